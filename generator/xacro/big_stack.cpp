#include "generator/xacro/big_stack.hpp"

#include <pthread.h>

#include <cstddef>
#include <exception>

namespace finemote::gen::xacro {
namespace {

constexpr std::size_t kStackSize = std::size_t{512} << 20;  // bytes

struct Job {
  const std::function<void()>* work;
  std::exception_ptr thrown;
};

void* run(void* argument) {
  auto* job = static_cast<Job*>(argument);
  try {
    (*job->work)();
  } catch (...) {
    job->thrown = std::current_exception();
  }
  return nullptr;
}

}  // namespace

void run_on_big_stack(const std::function<void()>& work) {
  Job job{&work, nullptr};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackSize);
  pthread_t thread{};
  const int failed = pthread_create(&thread, &attributes, run, &job);
  pthread_attr_destroy(&attributes);
  if (failed != 0) {
    run(&job);  // no memory for the thread: the bounds of ordinary inputs fit this stack as well
  } else {
    pthread_join(thread, nullptr);
  }
  if (job.thrown) std::rethrow_exception(job.thrown);
}

}  // namespace finemote::gen::xacro
