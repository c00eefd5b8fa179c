// Power flow in a recorded diagram, from its geometry and the rows of its statements.
const points = (d) => {
  const out = [];
  let x = 0;
  let y = 0;
  for (const [, op, a, b] of d.matchAll(/([MHVL])([\d.]+)(?: ([\d.]+))?/g)) {
    if (op === 'M' || op === 'L') [x, y] = [Number(a), Number(b)];
    else if (op === 'H') x = Number(a);
    else y = Number(a);
    out.push([x, y]);
  }
  return out;
};

export function flows(svg, rowOf) {
  const nets = [...svg.matchAll(/data-net="(\d+)"[^>]* d="([^"]+)"/g)].map(([, id, d]) => ({ id, points: points(d), value: 0 }));
  const elements = [...svg.matchAll(/<g class="symbol (\w+)" data-element="([^"]+)"[^>]*>([\s\S]*?)<\/g>/g)].map(([, kind, id, body]) => {
    const line = Number(/-(\d+)/.exec(id)[1]);
    const stroke = /class="stroke" d="M([\d.]+) ([\d.]+)V([\d.]+)M([\d.]+)/.exec(body);
    const face = /class="face" x="([\d.]+)" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)"/.exec(body);
    return { kind, id, line, left: stroke ? Number(stroke[1]) : face ? Number(face[1]) : 0, right: stroke ? Number(stroke[4]) : face ? Number(face[1]) + Number(face[3]) : 0, y: stroke ? (Number(stroke[2]) + Number(stroke[3])) / 2 : face ? Number(face[2]) + 26 : 0, closed: /M\d+ \d+L/.test(stroke ? body.slice(body.indexOf('class="stroke"')) : '') };
  });
  const touches = (net, x, y) => net.points.some(([a, b]) => Math.abs(a - x) < 1 && Math.abs(b - y) < 27);
  for (const net of nets) if (net.points.some(([x]) => x <= 10)) net.value = 1;
  for (let round = 0; round < 12; round += 1) {
    for (const e of elements) {
      const row = rowOf(e.line);
      const before = nets.find((net) => touches(net, e.left, e.y));
      const sta = row ? (row[2] >> 2) & 1 : 0;
      const rlo = row ? (row[2] >> 1) & 1 : 0;
      e.value = e.kind === 'contact' || e.kind === 'coil' ? sta : rlo;
      const pass = e.kind === 'contact' ? (e.closed ? 1 - sta : sta) : e.kind === 'edge' ? rlo : 1;
      e.flow = e.kind === 'contact' || e.kind === 'edge' || e.kind === 'coil' ? (before ? before.value & pass : e.kind === 'coil' ? rlo : pass) : rlo;
      if (e.kind === 'coil') continue;
      for (const net of nets) if (net !== before && touches(net, e.right, e.y) && e.flow) net.value = 1;
    }
  }
  return [...nets.map((net) => [net.id, net.value, '']), ...elements.map((e) => [e.id, e.flow, /contact|coil/.test(e.kind) ? String(e.value) : ''])];
}
