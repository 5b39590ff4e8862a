// The buffer of a writer: large enough that a call to the system costs little, small enough to stay in the cache.
#include "files/writer.h"

#include "operators/interrupt.h"

namespace udcp {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::size_t at_once = std::size_t{1} << 24;  // bytes that no stop interrupts

}  // namespace

Writer::Writer(std::size_t expected_size, const std::atomic<bool>* stop) : stop_(stop) {
  if (expected_size > buffer_size) text_.reserve(expected_size);
  make_room(std::clamp<std::size_t>(expected_size, 256, buffer_size));
}

Writer::Writer(std::filesystem::path file, const std::atomic<bool>* stop) : stop_(stop), to_file_(true), file_(std::move(file)) {
  make_room(buffer_size);
}

void Writer::make_room(std::size_t bytes) {
  flush();
  if (bytes <= static_cast<std::size_t>(end_ - at_)) return;
  const std::size_t size = std::max(bytes, std::min(buffer_size, 4 * static_cast<std::size_t>(end_ - at_)));
  buffer_ = std::make_unique_for_overwrite<char[]>(size);
  at_ = buffer_.get();
  end_ = at_ + size;
}

void Writer::flush() {
  if (at_ == buffer_.get()) return;
  pass_on({buffer_.get(), static_cast<std::size_t>(at_ - buffer_.get())});
  at_ = buffer_.get();
}

void Writer::write_large(std::string_view bytes) {
  flush();
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), at_once))) pass_on(bytes.substr(0, at_once));
}

void Writer::pass_on(std::string_view bytes) {
  throw_if_stopped(stop_);
  if (!to_file_) {
    text_.append(bytes);
  } else {
    if (!sink_) sink_.emplace(file_);
    sink_->write(bytes);
  }
}

std::string Writer::take() {
  flush();
  return std::move(text_);
}

void Writer::commit() {
  flush();
  throw_if_stopped(stop_);
  if (!sink_) sink_.emplace(file_);
  sink_->commit();
}

std::string comment_line(const std::string& word) {
  std::string line = "made by udcp";
  if (!word.empty()) line += ": ";
  for (const char c : word) line += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
  if (line.ends_with('\\')) line += ' ';  // a backslash would join the next line to the comment
  return line;
}

}  // namespace udcp
