// Declares what the writer and the readers of videos share: owners of libav's objects, and libav's
// errors in words.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <array>
#include <memory>
#include <new>
#include <string>

namespace spindrift::output {

/// Frees an object of libav as its type requires; demuxers and muxers share one type.
struct Free {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
  void operator()(AVFormatContext* p) const {
    if (p->iformat != nullptr) {
      avformat_close_input(&p);
    } else {
      avio_closep(&p->pb);
      avformat_free_context(p);
    }
  }
};
/// An object of libav that is freed with its owner.
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// Takes ownership of an object that libav has just allocated.
/// @throws std::bad_alloc for a null pointer
template <class T>
Owned<T> owned(T* pointer) {
  if (pointer == nullptr)
    throw std::bad_alloc();
  return Owned<T>(pointer);
}

/// Says what an error number of libav means.
inline std::string reason(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

}  // namespace spindrift::output
