// Text and JSON lines, flushed line by line so that results and diagnostics appear in the order they were made.
#include "interpreter/console.h"

#include <algorithm>
#include <cerrno>
#include <ostream>

namespace udcp {
namespace {

/// One JSON line; bytes that are no UTF-8 (file names may be anything) become U+FFFD instead of an exception.
std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

void ProgressBar::update(const std::string& what, double fraction, Clock::time_point now) {
  using std::chrono::milliseconds;
  fraction = fraction > 0 ? std::min(fraction, 1.0) : 0;  // also not-a-number
  if (what != what_ || fraction < fraction_) {
    what_ = what;
    begin_ = now;
  }
  fraction_ = fraction;
  if (now - begin_ < milliseconds(1000) || (visible_ && now - drawn_ < milliseconds(100))) return;
  constexpr int width = 30;
  const int done = static_cast<int>(fraction * width);
  stream_ << "\r\033[K" << what << " [" << std::string(static_cast<std::size_t>(done), '#')
          << std::string(static_cast<std::size_t>(width - done), '-') << "] " << static_cast<int>(fraction * 100) << " %"
          << std::flush;
  drawn_ = now;
  visible_ = true;
}

void ProgressBar::erase() {
  if (visible_) stream_ << "\r\033[K" << std::flush;
  visible_ = false;
}

void Console::value(const Value& value) {
  if (value.as<Nothing>() != nullptr) return;
  text(options_.json ? line_of(to_json(value)) : to_text(value));
}

void Console::text(const std::string& line) {
  progress_.erase();
  if (failed_) return;
  out_ << line << '\n';
  flush();
}

void Console::flush() {
  if (failed_) return;
  errno = 0;
  if (out_.flush()) return;
  failed_ = true;
  failure_ = errno;
  if (on_failure) on_failure();
}

void Console::warning(const std::string& message) {
  if (options_.quiet) return;
  progress_.erase();
  err_ << (options_.json ? line_of(warning_json(message)) : warning_text(message, options_.colour)) << std::endl;
}

void Console::error(const ProgramError& error) {
  progress_.erase();
  err_ << (options_.json ? line_of(to_json(error)) : to_text(error, options_.colour)) << std::endl;
}

void Console::progress(const std::string& what, double fraction) {
  if (options_.progress && !options_.quiet && !options_.json) progress_.update(what, fraction);
}

Output Console::output() {
  return {[this](const Value& value) { this->value(value); }, [this](const std::string& message) { warning(message); },
          [this](const std::string& what, double fraction) { progress(what, fraction); }};
}

}  // namespace udcp
