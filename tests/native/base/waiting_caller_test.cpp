#include "base/waiting_caller.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace gradmesh {
namespace {

TEST(WaitingCaller, tells_the_last_news_on_its_own_thread) {
  const std::thread::id here = std::this_thread::get_id();
  for (int round = 0; round < 200; ++round) {
    WaitingCaller caller;
    std::atomic<int> done = 0;
    int told = 0;
    caller.wait_for(
        [&] {
          EXPECT_NE(std::this_thread::get_id(), here);
          for (int i = 0; i < 20; ++i) {
            ++done;
            caller.there_is_news();
          }
        },
        [&] {
          EXPECT_EQ(std::this_thread::get_id(), here);
          told = done;
          return true;
        });
    EXPECT_EQ(told, 20);
    EXPECT_FALSE(caller.should_end());
  }
}

TEST(WaitingCaller, lets_the_work_know_that_it_is_not_wanted_any_more) {
  WaitingCaller caller;
  int told = 0;
  const auto work_until_the_end = [&] {
    while (!caller.should_end()) caller.there_is_news();
    caller.there_is_news();
  };
  const auto refuse = [&] {
    ++told;
    return false;
  };
  caller.wait_for(work_until_the_end, refuse);
  EXPECT_EQ(told, 1);
  // Nothing is asked again once the answer was no.
  caller.wait_for(work_until_the_end, refuse);
  EXPECT_EQ(told, 1);
}

TEST(WaitingCaller, throws_what_is_thrown_on_either_side) {
  WaitingCaller working;
  EXPECT_THROW(working.wait_for([] { throw std::runtime_error("work"); }, [] { return true; }),
               std::runtime_error);
  WaitingCaller telling;
  bool has_ended = false;
  EXPECT_THROW(telling.wait_for(
                   [&] {
                     while (!telling.should_end()) telling.there_is_news();
                     has_ended = true;
                   },
                   []() -> bool { throw std::logic_error("tell"); }),
               std::logic_error);
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace gradmesh
