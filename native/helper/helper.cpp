#include "helper/helper.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <istream>
#include <mutex>
#include <ostream>
#include <thread>

#include "base/utf8_path.h"
#include "helper/wire.h"
#include "service/service.h"

namespace gradmesh {
namespace {

/// What the caller sends, read on a thread of its own, which thus sees at once where the caller has
/// ended.
class Inbox {
 public:
  explicit Inbox(std::istream& in) : reader_([this, &in] { read(in); }) {}

  /// Waits for the next message. Returns nothing at the end. Throws Garbled.
  std::optional<Json> next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !messages_.empty() || has_ended_; });
    if (messages_.empty()) {
      if (fault_) throw Garbled(*fault_);
      return std::nullopt;
    }
    Json message = std::move(messages_.front());
    messages_.pop_front();
    return std::make_optional(std::move(message));
  }

  /// Says whether a call is at work, without which the end of the messages is no reason to end.
  void set_working(bool working) {
    const std::lock_guard lock(mutex_);
    is_working_ = working;
    end_if_nobody_waits();
  }

 private:
  void read(std::istream& in) {
    std::optional<std::string> fault;
    try {
      while (auto message = read_message(in)) {
        const std::lock_guard lock(mutex_);
        messages_.push_back(std::move(*message));
        changed_.notify_one();
      }
    } catch (const std::exception& error) {
      fault = error.what();
    }
    const std::lock_guard lock(mutex_);
    fault_ = fault;
    has_ended_ = true;
    end_if_nobody_waits();
    changed_.notify_one();
  }

  /// Ends the process where a caller has ended during a call, whatever it has sent before. A caller
  /// that sends what is no message is still there, and is told. Needs the mutex.
  void end_if_nobody_waits() const {
    if (is_working_ && has_ended_ && !fault_) std::_Exit(EXIT_FAILURE);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Json> messages_;
  std::optional<std::string> fault_;
  bool has_ended_ = false, is_working_ = false;
  /// The last member, so that what it uses lives longer.
  std::jthread reader_;
};

/// What is sent to the caller, from the thread of the calls and from one that shows that it lives.
class Outbox {
 public:
  explicit Outbox(std::ostream& out) : out_(out) {}

  void send(const Json& message) {
    const std::lock_guard lock(mutex_);
    write_message(out_, message);
  }

 private:
  std::ostream& out_;
  std::mutex mutex_;
};

/// Shows that a call is at work while it lives.
class Heartbeat {
 public:
  explicit Heartbeat(Outbox& out) : thread_([this, &out] { beat(out); }) {}
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;
  ~Heartbeat() {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_one();
  }

 private:
  void beat(Outbox& out) {
    constexpr std::chrono::seconds interval(1);
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, interval, [&] { return has_ended_; }))
      out.send({{"alive", true}});
  }

  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  /// The last member, so that what it uses lives longer.
  std::jthread thread_;
};

/// Returns the answer to a question that the caller is asked during a call.
Json ask(Inbox& in, Outbox& out, const Json& question) {
  out.send(question);
  const auto answer = in.next();
  if (!answer || !answer->is_object() || !answer->contains("answer")) throw GivenUp();
  return (*answer)["answer"];
}

/// Makes relative paths begin where they begin for the caller. A folder that is gone is none.
void go_to_folder(const Json& request) {
  if (!request.is_object() || !request.contains("folder") || !request["folder"].is_string()) return;
  std::error_code gone;
  std::filesystem::current_path(utf8_path(request["folder"].get<std::string>()), gone);
}

}  // namespace

int run_helper(std::istream& in, std::ostream& out) {
  Outbox outbox(out);
  Inbox inbox(in);
  Service service;
  try {
    while (const auto request = inbox.next()) {
      inbox.set_working(true);
      Json outcome;
      {
        const Heartbeat alive(outbox);
        go_to_folder(*request);
        outcome = service.call(*request, [&](const Json& q) { return ask(inbox, outbox, q); });
      }
      inbox.set_working(false);
      outbox.send(outcome);
    }
  } catch (const Garbled& error) {
    outbox.send({{"error", "garbled"}, {"text", error.what()}});
    return 1;
  } catch (const std::exception&) {
    // The reader may be waiting for input, and nothing ends that.
    std::_Exit(EXIT_FAILURE);
  }
  return 0;
}

}  // namespace gradmesh
