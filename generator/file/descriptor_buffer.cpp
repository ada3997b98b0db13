#include "generator/file/descriptor_buffer.hpp"

#include <unistd.h>

#include <cerrno>

namespace finemote::gen {

void DescriptorBuffer::attach(int descriptor) {
  descriptor_ = descriptor;
  error_ = 0;
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type letter) {
  if (!drain()) return traits_type::eof();
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  return sputc(traits_type::to_char_type(letter));
}

std::streamsize DescriptorBuffer::xsputn(const char* text, std::streamsize size) {
  if (size < epptr() - pptr()) return std::streambuf::xsputn(text, size);
  return drain() && put(text, static_cast<std::size_t>(size)) ? size : 0;
}

bool DescriptorBuffer::drain() {
  const auto waiting = static_cast<std::size_t>(pptr() - pbase());
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return put(buffer_.data(), waiting);
}

bool DescriptorBuffer::put(const char* text, std::size_t size) {
  while (error_ == 0 && size > 0) {
    const ssize_t written = ::write(descriptor_, text, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = errno;
      break;
    }
    text += written;
    size -= static_cast<std::size_t>(written);
  }
  return error_ == 0;
}

}  // namespace finemote::gen
