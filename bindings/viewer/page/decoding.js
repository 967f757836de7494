"use strict";

// Turns the texts of the page back into numbers.

const digitsOfBase85 =
  "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%,()*+-;.=/?@^_`{|}~";

/** The bytes of a text of base 85: four of five digits, n - 1 of the last n ones. */
function bytesOfBase85(text) {
  const digits = new Uint8Array(128), bytes = new Uint8Array(Math.floor((4 * text.length) / 5));
  [...digitsOfBase85].forEach((digit, value) => { digits[digit.charCodeAt(0)] = value; });
  for (let i = 0, place = 0; i < text.length; i += 5) {
    let number = 0;
    for (let k = i; k < i + 5; ++k) number = 85 * number + (k < text.length ? digits[text.charCodeAt(k)] : 84);
    for (let shift = 24; shift >= 0 && place < bytes.length; shift -= 8) bytes[place++] = number >>> shift;
  }
  return bytes;
}

/** The bytes of an element of the page. */
async function bytesOf(id) {
  const packed = bytesOfBase85(document.getElementById(id).textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Reads consecutive numbers, the lowest byte first. */
class ByteReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.place = 0;
  }

  byte() {
    return this.bytes[this.place++];
  }

  whole() {
    return this.wholes(1)[0];
  }

  wholes(count) {
    return new Uint32Array(this.take(4 * count));
  }

  floats(count) {
    return new Float32Array(this.take(4 * count));
  }

  take(size) {
    return this.view(size).slice().buffer;
  }

  /** The next bytes, which are not copied. */
  view(size) {
    this.place += size;
    return this.bytes.subarray(this.place - size, this.place);
  }
}

/** A column as it is stored: whole numbers of all frames or their differences, in planes of bytes. */
class PackedColumn {
  constructor(reader, itemCount, frameCount, {step, dropped_bits: droppedBits}) {
    Object.assign(this, {itemCount, step, droppedBits, total: itemCount * frameCount});
    this.order = reader.byte();
    this.planeCount = reader.byte();
    this.bytes = reader.view(this.planeCount * this.total);
  }

  /** The values, frame after frame: multiples of a step, or floats whose lower bits have been dropped. */
  unpacked() {
    const codes = this.codes(), {step, droppedBits, total} = this;
    const values = new Float32Array(step ? total : codes.buffer);
    for (let i = 0; i < total; ++i) {
      if (step) values[i] = codes[i] * step;
      else codes[i] = codes[i] < 0 ? (-codes[i] << droppedBits) | 0x80000000 : codes[i] << droppedBits;
    }
    return values;
  }

  codes() {
    const {itemCount, total, order, planeCount, bytes} = this, codes = new Int32Array(total);
    for (let plane = 0; plane < planeCount; ++plane)
      for (let i = 0, at = plane * total, shift = 8 * plane; i < total; ++i, ++at) codes[i] |= bytes[at] << shift;
    for (let i = 0; i < total; ++i) codes[i] = (codes[i] >>> 1) ^ -(codes[i] & 1);
    for (let sum = 0; sum < order; ++sum)
      for (let i = itemCount; i < total; ++i) codes[i] += codes[i - itemCount];
    return codes;
  }
}
