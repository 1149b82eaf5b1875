// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/llrp/access.hpp"

/// Layouts of access.hpp (LLRP 1.0.1, 16.2.5, 16.3.1.3, 16.3.1.5.5), both directions.
namespace sensotwin::robot::llrp {

template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2TargetTag> v) {
  io.two_bits(v.bank, v.match);
  io.number(v.bit_pointer);
  io.bits(v.mask);
  io.bits(v.data);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2TagSpec> v) {
  io.children([&](auto& slots) { slots.list(v.targets, 1, 2); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Read> v) {
  io.number(v.op);
  io.number(v.password);
  io.two_bits(v.bank);
  io.number(v.word);
  io.number(v.count);
}
template <class Io, class Writing>
void layout_of_writing(Io& io, Writing& v) {
  io.number(v.op);
  io.number(v.password);
  io.two_bits(v.bank);
  io.number(v.word);
  io.counted(v.data);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Write> v) {
  layout_of_writing(io, v);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2BlockWrite> v) {
  layout_of_writing(io, v);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Kill> v) {
  io.number(v.op);
  io.number(v.password);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2LockPayload> v) {
  io.number(v.privilege);
  io.number(v.data_field);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Lock> v) {
  io.number(v.op);
  io.number(v.password);
  io.children([&](auto& slots) { slots.list(v.payloads, 1); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2BlockErase> v) {
  io.number(v.op);
  io.number(v.password);
  io.two_bits(v.bank);
  io.number(v.word);
  io.number(v.count);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AccessCommand> v) {
  io.children([&](auto& slots) {
    slots.one(v.tags);
    slots.any_of(v.operations, 1);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AccessSpecStopTrigger> v) {
  io.code(v.kind, AccessStop::kCount);
  io.number(v.count);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AccessSpec> v) {
  io.number(v.id);
  io.number(v.antenna);
  io.number(v.protocol);
  io.flags8(v.active);
  io.number(v.ro_spec_id);
  io.children([&](auto& slots) {
    slots.one(v.stop);
    slots.one(v.command);
    slots.maybe(v.report);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2ReadResult> v) {
  io.code(v.result, ReadResult::kReaderError);
  io.number(v.op);
  io.counted(v.words);
}
template <class Io, class Result>
void layout_of_writing_result(Io& io, Result& v) {
  io.code(v.result, WriteResult::kReaderError);
  io.number(v.op);
  io.number(v.words_written);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2WriteResult> v) {
  layout_of_writing_result(io, v);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2BlockWriteResult> v) {
  layout_of_writing_result(io, v);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2KillResult> v) {
  io.number(v.result);
  io.number(v.op);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2LockResult> v) {
  io.number(v.result);
  io.number(v.op);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2BlockEraseResult> v) {
  io.number(v.result);
  io.number(v.op);
}

}  // namespace sensotwin::robot::llrp
