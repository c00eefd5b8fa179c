/** A push button: pressed while the pointer, Space or Enter holds it. */
export function hold(node: HTMLElement | SVGElement, set: (down: boolean) => void): { update(next: (down: boolean) => void): void; destroy(): void } {
  let down = false;
  const change = (to: boolean): void => {
    if (down === to) return;
    if (to && (node.getAttribute('aria-disabled') === 'true' || (node as HTMLButtonElement).disabled)) return;
    down = to;
    set(to);
  };
  const press = (event: Event): void => {
    if (event instanceof PointerEvent) {
      if (event.button !== 0) return;
      node.setPointerCapture(event.pointerId);
    }
    change(true);
  };
  const release = (): void => change(false);
  const key = (event: Event): void => {
    const pressed = event as KeyboardEvent;
    if (pressed.key !== ' ' && pressed.key !== 'Enter') return;
    pressed.preventDefault();
    pressed.stopPropagation();
    if (!pressed.repeat) change(pressed.type === 'keydown');
  };
  /** A long touch is a press, no menu. */
  const menu = (event: Event): void => {
    if (down) event.preventDefault();
  };
  const events: [string, (event: Event) => void][] = [['pointerdown', press], ['pointerup', release], ['pointercancel', release], ['lostpointercapture', release], ['blur', release], ['keydown', key], ['keyup', key], ['contextmenu', menu]];
  for (const [name, handler] of events) node.addEventListener(name, handler);
  return {
    update(next) {
      set = next;
    },
    destroy() {
      change(false);
      for (const [name, handler] of events) node.removeEventListener(name, handler);
    },
  };
}
