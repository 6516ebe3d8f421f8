#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <streambuf>

namespace gradmesh::test {

/// A stream buffer that one thread writes and another one reads, who waits for what is not there.
class Pipe : public std::streambuf {
 public:
  /// Ends the stream after all that was written.
  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

 protected:
  int_type overflow(int_type c) override {
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      const char byte = traits_type::to_char_type(c);
      xsputn(&byte, 1);
    }
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const std::lock_guard lock(mutex_);
    bytes_.insert(bytes_.end(), bytes, bytes + count);
    changed_.notify_all();
    return count;
  }

  // There is no get area, whose pointers the writer would have to move.
  int_type underflow() override {
    std::unique_lock lock(mutex_);
    return next(lock);
  }
  int_type uflow() override {
    std::unique_lock lock(mutex_);
    const int_type c = next(lock);
    if (!bytes_.empty()) bytes_.pop_front();
    return c;
  }

 private:
  int_type next(std::unique_lock<std::mutex>& lock) {
    // Whoever never writes makes a test fail, not hang.
    constexpr std::chrono::minutes patience(5);
    changed_.wait_for(lock, patience, [&] { return is_closed_ || !bytes_.empty(); });
    return bytes_.empty() ? traits_type::eof() : traits_type::to_int_type(bytes_.front());
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<char> bytes_;
  bool is_closed_ = false;
};

}  // namespace gradmesh::test
