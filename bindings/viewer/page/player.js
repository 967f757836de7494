"use strict";

/** Plays the frames, at a rate that shows a short run for some seconds. */
class Player {
  constructor(frameCount, show) {
    Object.assign(this, {frameCount, show, isPlaying: false, repeats: true, rate: 1, number: 0, onStop: () => {}});
    this.framesPerSecond = Math.min(Math.max(frameCount / 8, 6), 30);
  }

  play() {
    if (this.frameCount < 2) return;
    if (this.number === this.frameCount - 1) this.number = 0;
    this.isPlaying = true;
    this.beginFrom(this.number);
    requestAnimationFrame(() => this.tick());
  }

  pause() {
    this.isPlaying = false;
    this.onStop();
  }

  beginFrom(number) {
    this.first = number;
    this.begin = performance.now();
  }

  setRate(rate) {
    this.rate = rate;
    this.beginFrom(this.number);
  }

  /** Shows the frame that is due; those that a slow machine has no time for are left out. */
  async tick() {
    if (!this.isPlaying) return;
    const passed = (performance.now() - this.begin) / 1000;
    const due = this.first + Math.floor(passed * this.framesPerSecond * this.rate);
    const isOver = due >= this.frameCount;
    if (isOver && this.repeats) this.beginFrom(0);
    const number = !isOver ? due : this.repeats ? 0 : this.frameCount - 1;
    if (number !== this.number) {
      this.number = number;
      await this.show(number);
    }
    if (isOver && !this.repeats) this.pause();
    requestAnimationFrame(() => this.tick());
  }

  goTo(number) {
    this.number = Math.min(Math.max(number, 0), this.frameCount - 1);
    this.beginFrom(this.number);
    return this.show(this.number);
  }
}
