// The plants of the development server, as far as the page has to show them.
export const dosing = {
  head: {
    name: 'plant', kind: 'dosing', title: 'Dosing plant', detail: '25 litres a dose',
    signals: [
      { name: 'start', address: 'I 0.0', direction: 'in', driven: 'user', handle: 'push' },
      { name: 'stop', address: 'I 0.1', direction: 'in', driven: 'user', handle: 'push-nc' },
      { name: 'flow', address: 'I 0.7', direction: 'in', driven: 'plant' },
      { name: 'valve', address: 'Q 0.0', direction: 'out', driven: 'plant' },
      { name: 'display', address: 'QW 4', direction: 'out', driven: 'plant' },
    ],
  },
  begin: () => ({ vessel: 0, delivered: 0, supply: 250, spilled: 0, auto: true, idle: 0, held: 0, cycle: 0 }),
  hands: { 'I 0.1': 1 },
  step(p, vars, dt, faults) {
    if (p.auto) {
      p.idle += dt;
      if (!vars['Q 0.0'] && p.idle > 1 && p.held === 0) {
        vars['I 0.0'] = 1;
        p.held = 0.35;
        p.vessel = 0;
        if (p.supply < 30) p.supply = 250;
      } else if (p.held > 0) {
        p.held -= dt;
        if (p.held <= 0) {
          vars['I 0.0'] = 0;
          p.held = 0;
        }
      }
      if (vars['Q 0.0']) p.idle = -2;
    }
    if (vars['Q 0.0'] && p.supply > 0) {
      const flow = 2.5 * dt;
      p.supply -= flow;
      p.delivered += flow;
      p.vessel += flow;
      if (p.vessel > 30) {
        p.spilled += p.vessel - 30;
        p.vessel = 30;
      }
    }
    vars['I 0.7'] = faults.flow === 'stuck=0' ? 0 : faults.flow === 'stuck=1' ? 1 : p.delivered >= 1 && p.delivered % 1 < 0.5 ? 1 : 0;
  },
  look: (p, vars, faults) => ({
    kind: 'dosing', name: 'plant', input: 0, output: 0, parameters: [2.5, 20, 250, 30],
    inputs: [vars['I 0.0'] | (vars['I 0.1'] << 1) | (vars['I 0.7'] << 7)],
    outputs: [vars['Q 0.0'] | 0, 0, 0, 0, ((vars['QW 4'] | 0) >> 8) & 255, (vars['QW 4'] | 0) & 255],
    state: [['delivered', p.delivered, 'l'], ['supply', p.supply, 'l'], ['vessel', p.vessel, 'l'], ['spilled', p.spilled, 'l']],
    faults: Object.entries(faults).map(([name, fault]) => `${name} ${fault}`),
  }),
};

export const motor = {
  head: {
    name: 'motor', kind: 'motor', title: 'Motor', detail: 'star-delta',
    signals: [
      ['line_on', 'I 0.0', 'in'], ['star_on', 'I 0.1', 'in'], ['delta_on', 'I 0.2', 'in'], ['overload', 'I 0.3', 'in'], ['turning', 'I 0.4', 'in'], ['line', 'Q 0.0', 'out'], ['star', 'Q 0.1', 'out'], ['delta', 'Q 0.2', 'out'],
    ].map(([name, address, direction]) => ({ name, address, direction, driven: 'plant' })).concat([
      { name: 'start', address: 'I 8.0', direction: 'in', driven: 'user', handle: 'push' },
      { name: 'stop', address: 'I 8.1', direction: 'in', driven: 'user', handle: 'switch-nc' },
      { name: 'emergency', address: 'I 8.2', direction: 'in', driven: 'user', handle: 'switch-nc' },
    ]),
  },
  begin: () => ({ speed: 0, heat: 0, current: 0, auto: true, idle: 0, held: 0 }),
  hands: { 'I 8.1': 1, 'I 8.2': 1, 'I 0.3': 1 },
  step(p, vars, dt) {
    if (p.auto) {
      p.idle += dt;
      vars['I 8.0'] = p.idle > 0.5 && p.idle < 0.8 ? 1 : 0;
    }
    vars['I 0.0'] = vars['Q 0.0'] | 0;
    vars['I 0.1'] = vars['Q 0.1'] | 0;
    vars['I 0.2'] = vars['Q 0.2'] | 0;
    const driven = vars['I 0.0'] && (vars['I 0.1'] || vars['I 0.2']);
    const goal = driven ? (vars['I 0.2'] ? 99 : 82) : 0;
    p.speed += (goal - p.speed) * dt * (driven ? 0.9 : 0.4);
    p.current = driven ? (vars['I 0.2'] ? 7 : 2.3) * (100 - p.speed) + 40 : 0;
    p.heat += (Math.min(100, (p.current / 100) ** 2 * 3) - p.heat) * dt * 0.1;
    vars['I 0.4'] = p.speed > 80 ? 1 : 0;
  },
  look: (p, vars) => ({
    kind: 'motor', name: 'motor', input: 0, output: 0, parameters: [3, 40, 10],
    inputs: [vars['I 0.0'] | (vars['I 0.1'] << 1) | (vars['I 0.2'] << 2) | (vars['I 0.3'] << 3) | (vars['I 0.4'] << 4), 0, 0, 0, 0, 0],
    outputs: [vars['Q 0.0'] | (vars['Q 0.1'] << 1) | (vars['Q 0.2'] << 2)],
    state: [['speed', p.speed, '%'], ['current', p.current, '%'], ['heat', p.heat, '%'], ['fuse_blown', 0, ''], ['starts', 1, '']],
    faults: [],
  }),
};

export const tank = {
  head: {
    name: 'tank', kind: 'tank', title: 'Tank', detail: '500 litres',
    signals: [
      ['low', 'I 0.0', 'in'], ['high', 'I 0.1', 'in'], ['overflow', 'I 0.2', 'in'], ['inlet_open', 'I 0.3', 'in'], ['outlet_open', 'I 0.4', 'in'], ['level', 'IW 2', 'in'], ['inlet', 'Q 0.0', 'out'], ['outlet', 'Q 0.1', 'out'],
    ].map(([name, address, direction]) => ({ name, address, direction, driven: 'plant' })),
  },
  begin: () => ({ level: 20, inlet: 1 }),
  hands: { 'I 8.0': 1, 'I 0.2': 1 },
  step(p, vars, dt) {
    if (p.level > 60) p.inlet = 0;
    if (p.level < 40) p.inlet = 1;
    vars['Q 0.0'] = p.inlet;
    vars['Q 0.1'] = vars['I 8.1'] ? 1 : 0;
    p.level += (p.inlet ? 2 : 0) * dt - (vars['Q 0.1'] ? 1.5 : p.inlet ? 0 : 0.6) * dt;
    vars['I 0.0'] = p.level > 10 ? 1 : 0;
    vars['I 0.1'] = p.level > 90 ? 1 : 0;
    vars['I 0.3'] = p.inlet;
    vars['IW 2'] = Math.round(p.level * 276.48);
    vars['MD 20'] = Math.round(p.level * 10) / 10;
    vars['M 10.2'] = p.level < 40 ? 1 : 0;
  },
  look: (p, vars) => ({
    kind: 'tank', name: 'tank', input: 0, output: 0, parameters: [500, 10, 8, 20, 0.2],
    inputs: [vars['I 0.0'] | (vars['I 0.1'] << 1) | (vars['I 0.2'] << 2) | (vars['I 0.3'] << 3) | ((vars['I 0.4'] | 0) << 4), 0, vars['IW 2'] >> 8, vars['IW 2'] & 255],
    outputs: [vars['Q 0.0'] | (vars['Q 0.1'] << 1), 0, 0, 0],
    state: [['level', p.level, '%'], ['content', p.level * 5, 'l'], ['spilled', 0, 'l']],
    faults: [],
  }),
};
export const PLANTS = { dosing, 'star-delta': motor, tank };
