// Tells a click or tap from a drag, and a long press from both.

const STILL = 6;  // [CSS px] that a still finger may move
const LONG = 550;  // [ms] of a long press

// onClick(event), onPress(event): Shift and a click, or a long press. Returns what ends it.
export function listen(canvas, onClick, onPress) {
  const down = new Set();  // fingers and buttons
  let start;
  let timer = 0;

  const forget = () => {
    start = undefined;
    clearTimeout(timer);
  };
  const listeners = {
    pointerdown(event) {
      forget();
      down.add(event.pointerId);
      if (event.button !== 0 || down.size > 1) return;
      start = event;
      if (event.pointerType !== 'mouse') {
        timer = setTimeout(() => {
          forget();
          onPress(event);
        }, LONG);
      }
    },
    pointermove(event) {
      if (start && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) > STILL) forget();
    },
    pointerup(event) {
      down.delete(event.pointerId);
      if (!start || event.pointerId !== start.pointerId) return;
      const long = event.timeStamp - start.timeStamp >= LONG;
      const {shiftKey} = start;
      forget();
      if (long || shiftKey) onPress(event);
      else onClick(event);
    },
    pointercancel(event) {
      down.delete(event.pointerId);
      forget();
    },
  };
  for (const [name, listener] of Object.entries(listeners)) canvas.addEventListener(name, listener);
  return () => {
    forget();
    for (const [name, listener] of Object.entries(listeners)) canvas.removeEventListener(name, listener);
  };
}
