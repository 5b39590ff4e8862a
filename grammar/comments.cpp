// One walk over the statements and one over the comments, side by side.
#include "grammar/comments.h"

#include <algorithm>
#include <string>

namespace udcp::grammar {
namespace {

class Placing {
 public:
  Placing(std::string_view text, const std::vector<Span>& comments) : text_(text), comments_(comments) {}

  /// A list of statements in [begin, end); comments behind the last one go to `after`.
  void list(std::vector<Statement>& statements, std::size_t begin, std::size_t end, std::vector<std::string>& after) {
    last_ = begin;
    bool first = true;
    for (Statement& statement : statements) {
      const std::size_t place = statement.span.begin;
      statement.blank_before = !first && blank(open(place) ? comments_[next_].begin : place);
      move(place, statement.comments_before);
      if (!statement.comments_before.empty() && blank(place)) statement.comments_before.emplace_back("\n");
      inside(statement);
      last_ = statement.span.end;
      behind(statement, end);
      first = false;
    }
    if (!first && open(end) && blank(comments_[next_].begin)) after.emplace_back("\n");
    move(end, after);
  }

 private:
  [[nodiscard]] bool open(std::size_t end) const { return next_ < comments_.size() && comments_[next_].begin < end; }

  std::string take() {
    const Span span = comments_[next_++];
    last_ = span.end;
    std::string_view comment = text_.substr(span.begin + 1, span.end - span.begin - 1);
    while (!comment.empty() && (comment.back() == ' ' || comment.back() == '\t' || comment.back() == '\r'))
      comment.remove_suffix(1);
    return std::string(comment);
  }

  /// Whether an empty line stands between the last thing placed and `offset`.
  [[nodiscard]] bool blank(std::size_t offset) const {
    return std::count(text_.begin() + static_cast<std::ptrdiff_t>(last_), text_.begin() + static_cast<std::ptrdiff_t>(offset),
                      '\n') > 1;
  }

  /// Moves the comments before `end` to the list, with blank lines between them.
  void move(std::size_t end, std::vector<std::string>& list) {
    for (bool first = true; open(end); first = false) {
      if (!first && blank(comments_[next_].begin)) list.emplace_back("\n");
      list.push_back(take());
    }
  }

  /// Comments inside a statement: a block has places for them, from elsewhere they move above the statement.
  void inside(Statement& statement) {
    std::vector<Statement>* body = nullptr;
    std::vector<std::string>* after = nullptr;
    if (Sweep* sweep = std::get_if<Sweep>(&statement.node)) body = &sweep->body, after = &sweep->comments_after;
    if (Animate* animate = std::get_if<Animate>(&statement.node)) body = &animate->body, after = &animate->comments_after;
    if (body) {
      list(*body, statement.span.begin, statement.span.end, *after);
      return;
    }
    std::vector<std::string> moved;
    move(statement.span.end, moved);
    std::erase(moved, "\n");
    statement.comments_before.insert(statement.comments_before.end(), moved.begin(), moved.end());
  }

  void behind(Statement& statement, std::size_t end) {
    if (!open(end)) return;
    const std::string_view between = text_.substr(last_, comments_[next_].begin - last_);
    const bool same_line = between.find_first_not_of(" \t") == std::string_view::npos;
    if (same_line) statement.comment_after = take();
  }

  std::string_view text_;
  const std::vector<Span>& comments_;
  std::size_t next_ = 0;  // the first comment without a place
  std::size_t last_ = 0;  // end of the last thing placed
};

}  // namespace

void place_comments(Program& program, std::string_view text, const std::vector<Span>& comments) {
  Placing(text, comments).list(program.statements, 0, text.size(), program.comments_after);
}

}  // namespace udcp::grammar
