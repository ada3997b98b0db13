// A stream buffer that writes to a file descriptor and remembers why it could not.
#pragma once

#include <array>
#include <streambuf>

namespace finemote::gen {

/// Unlike the buffers of the standard library, it keeps the system's error number of the first write that failed,
/// however late the writer asks. Whatever is written after that is dropped, and the stream is bad.
class DescriptorBuffer : public std::streambuf {
 public:
  /// Does not own the descriptor.
  explicit DescriptorBuffer(int descriptor = -1) { attach(descriptor); }
  DescriptorBuffer(const DescriptorBuffer&) = delete;
  DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;

  /// Starts on another descriptor, with nothing written and no error.
  void attach(int descriptor);
  /// errno of the first write that failed; 0 when all went well so far. Flush the stream before asking.
  [[nodiscard]] int error() const { return error_; }

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override { return drain() ? 0 : -1; }

 private:
  bool drain();
  bool put(const char* text, std::size_t size);

  int descriptor_ = -1;
  int error_ = 0;
  std::array<char, 1 << 14> buffer_{};
};

}  // namespace finemote::gen
