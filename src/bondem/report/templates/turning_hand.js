  // Pixels of a unit of places, by which the body fills the canvas in whatever way it is turned.
  const fitted = (places, margin, width, height) => {
    const reach = row => {
      let most = 1;
      for (let k = 0; k < places.length; k += 3)
        most = Math.max(most, Math.abs(row[0] * places[k] + row[1] * places[k + 1] + row[2] * places[k + 2]));
      return most + margin;
    };
    return 0.48 * zoom * Math.min(width / reach(R[0]), height / reach(R[1]));
  };
  const plan = () => { if (!planned) { planned = true; requestAnimationFrame(draw); } };
  const turn = (dx, dy) => {
    const mix = (p, q, angle) => {
      const c = Math.cos(angle), s = Math.sin(angle);
      [R[p], R[q]] = [R[p].map((v, k) => c * v + s * R[q][k]), R[q].map((v, k) => c * v - s * R[p][k])];
    };
    mix(0, 2, dx); mix(1, 2, -dy); plan();
  };
  const held = new Map();
  canvas.addEventListener("pointerdown", e => { held.set(e.pointerId, e); canvas.setPointerCapture(e.pointerId); });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, e => held.delete(e.pointerId));
  canvas.addEventListener("pointermove", e => {
    const last = held.get(e.pointerId);
    if (!last) return;
    if (held.size === 2) {
      const other = [...held.values()].find(one => one.pointerId !== e.pointerId);
      const far = one => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
      zoom = Math.min(8, Math.max(0.5, zoom * far(e) / Math.max(far(last), 1))); plan();
    } else turn((e.clientX - last.clientX) / 160, (e.clientY - last.clientY) / 160);
    held.set(e.pointerId, e);
  });
  canvas.addEventListener("wheel", e => {
    if (!e.ctrlKey) return;
    e.preventDefault(); zoom = Math.min(8, Math.max(0.5, zoom * Math.exp(-e.deltaY / 300))); plan();
  }, { passive: false });
  canvas.tabIndex = 0;
  canvas.addEventListener("keydown", e => {
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
    if (step) { e.preventDefault(); turn(...step); }
  });
  window.addEventListener("resize", plan);
  plan();
