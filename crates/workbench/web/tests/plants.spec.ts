// Pictures of plants: each example with a plant is operated as its README says, and its picture follows. Also check 13 of the contract.
import { expect, id, open, test, type Page } from './sieben';

const sentence = (page: Page, plant = 0) => id(page, 'plant-sentence').nth(plant);
const is = (page: Page, signal: string, on: 0 | 1) => expect(id(page, `plant-${signal}`).first()).toHaveAttribute('data-on', String(on));
/** An input that no plant drives, switched in the rack. */
const toggle = (page: Page, channel: string) => id(page, `in-${channel}`).getByRole('switch').click();

async function press(page: Page, name: string, ms = 150): Promise<void> {
  await id(page, name).hover();
  await page.mouse.down();
  await page.waitForTimeout(ms);
  await page.mouse.up();
}

test('the dosing plant is operated by mouse and by keys', async ({ page }) => {
  const wrong = await open(page);
  await expect(id(page, 'plant-picture')).toHaveAccessibleName('Dosing plant plant');
  await expect(sentence(page)).toContainText('The valve is shut.');
  await press(page, 'plant-start');
  await is(page, 'start', 0);
  await is(page, 'valve', 1);
  await expect(sentence(page)).toContainText(/The valve is open\..*l flow each second\./);
  await id(page, 'plant-stop').focus();
  await page.keyboard.down('Space');
  await is(page, 'stop', 0);
  await is(page, 'valve', 0);
  await page.keyboard.up('Space');
  await is(page, 'stop', 1);
  await expect(sentence(page)).toContainText('The valve is shut.');
  expect(wrong).toEqual([]);
});

test.describe('ten times as fast', () => {
  test.use({ further: ['--speed', '10x'] });
  test('13: a fault comes from the menu, is said in words, and ends by the menu', async ({ page }) => {
    await open(page);
    await press(page, 'plant-start');
    await is(page, 'valve', 1);
    await id(page, 'plant-fault').click();
    await page.getByRole('menuitemcheckbox', { name: 'flow stuck=0' }).click();
    await expect(page.getByRole('menuitemcheckbox', { name: 'flow stuck=0' })).toHaveAttribute('aria-checked', 'true');
    await expect(id(page, 'plant-faults')).toContainText('FLOW: stuck at 0');
    await expect(id(page, 'label-flow')).toContainText('✕ stuck at 0');
    const litres = () => page.evaluate(async () => ((await (await fetch('/api/v1/tags?names=C 0')).json()) as unknown));
    const before = JSON.stringify(await litres());
    await expect.poll(async () => Number.parseFloat((await id(page, 'vessel').textContent()) ?? '')).toBeGreaterThan(25);
    expect(JSON.stringify(await litres()).replace(/"scan":\d+/, '')).toBe(before.replace(/"scan":\d+/, ''));
    await page.getByRole('menuitemcheckbox', { name: 'flow stuck=0' }).click();
    await expect(page.getByRole('menuitemcheckbox', { name: 'flow stuck=0' })).toHaveAttribute('aria-checked', 'false');
    await expect(id(page, 'plant-faults')).toHaveCount(0);
  });
});

test.describe('tank', () => {
  test.use({ example: 'tank' });
  test('the level is kept; a sensor that is stuck is marked', async ({ page }) => {
    await open(page);
    await expect(id(page, 'level')).toHaveText('20.0 %');
    await toggle(page, '8.0');
    await is(page, 'inlet', 1);
    await expect(sentence(page)).toContainText('The inlet is open, the outlet shut.');
    await is(page, 'inlet_open', 1);
    await expect.poll(async () => Number.parseFloat((await id(page, 'level').textContent()) ?? '')).toBeGreaterThan(21);
    await id(page, 'plant-fault').click();
    await page.keyboard.press('ArrowDown');
    await id(page, 'plant-fault-level-stuck=0').focus();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Escape');
    await expect(id(page, 'plant-faults')).toContainText('LevelRaw: stuck at 0');
    await expect(id(page, 'label-level')).toContainText('✕ stuck at 0');
    await expect(id(page, 'plant-fault')).toContainText('1');
    await expect(id(page, 'in-IW2')).toContainText('0.0 %');
  });
});

test.describe('star-delta', () => {
  test.use({ example: 'star-delta' });
  test('the motor starts in star and goes on in delta', async ({ page }) => {
    await open(page);
    await expect(sentence(page)).toContainText('The motor stands');
    for (const channel of ['8.1', '8.2', '8.0']) await toggle(page, channel);
    await expect(id(page, 'plant-star')).toHaveAttribute('data-closed', '1');
    await expect(sentence(page)).toContainText('runs in star');
    await expect(id(page, 'plant-delta')).toHaveAttribute('data-closed', '1');
    await expect(id(page, 'plant-star')).toHaveAttribute('data-closed', '0');
    await expect(sentence(page)).toContainText('runs in delta');
    await expect.poll(async () => Number(await id(page, 'motor-speed').getAttribute('data-value'))).toBeGreaterThan(70);
    await toggle(page, '8.1');
    await expect(sentence(page)).toContainText('coasts');
  });
});

test.describe('conveyor and training panel', () => {
  test.use({ example: 'conveyor' });
  test('two plants, one below the other: the decade switch moves the belt', async ({ page }) => {
    await open(page);
    await expect(id(page, 'plant-picture')).toHaveCount(2);
    const [belt, panel] = [id(page, 'plant-of-belt'), id(page, 'plant-of-panel')];
    expect((await belt.boundingBox())?.y).toBeLessThan((await panel.boundingBox())?.y ?? 0);
    await expect(belt.getByRole('heading')).toHaveText('Conveyor');
    await expect(panel.getByRole('heading')).toHaveText('Training panel');
    await id(page, 'plant-decade-0').focus();
    await page.keyboard.press('ArrowUp');
    await expect(id(page, 'plant-thumbwheel')).toHaveAttribute('data-value', '0001');
    await is(page, 'right', 1);
    await expect(sentence(page)).toContainText('The belt runs to the right at 0.50 m/s.');
    await expect(panel.getByTestId('plant-motor_right')).toHaveAttribute('data-on', '1');
    await press(page, 'plant-put');
    await expect(sentence(page)).toContainText('Parts on it: 1');
    await is(page, 'right_end', 1);
    await is(page, 'right', 0);
    await expect(sentence(page)).toContainText('The part on the scale has');
    await expect.poll(async () => Number(await id(page, 'plant-weight').getAttribute('data-value'))).toBeGreaterThan(400);
    await panel.getByTestId('plant-selector_0').click();
    await expect(sentence(page)).toContainText('delivered: 1');
    await page.keyboard.press('Tab');
    await id(page, 'plant-decade-0').focus();
    await page.keyboard.press('4');
    await expect(sentence(page)).toContainText('The horn sounds.');
    await expect(panel.getByTestId('plant-horn')).toHaveAttribute('data-on', '1');
  });
});

test.describe('decade switches', () => {
  test.use({ example: 'decade-switches' });
  test('what is set on the panel is shown on its display', async ({ page }) => {
    await open(page);
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '0000');
    for (const [place, digit] of [[3, '1'], [2, '2'], [1, '3'], [0, '4']] as const) {
      await id(page, `plant-decade-${place}`).focus();
      await page.keyboard.press(digit);
      await expect(id(page, `plant-decade-${place}`)).toHaveAttribute('aria-valuenow', digit);
    }
    for (const bit of [4, 1]) await id(page, `plant-switch_1_${bit}`).click();
    await id(page, 'plant-selector_0').click();
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '4808');
    await is(page, 'lamp_0_1', 1);
    await expect(sentence(page)).toHaveText('Inputs at 1: E 1.4, E 1.1, Multiply. The decade switches stand at 1234. Lamps on: OverflowLamp. The display shows 4808.');
    await expect(id(page, 'plant-lamp_0_1')).toHaveText('1');
    await id(page, 'plant-decade-3').getByRole('button', { name: 'one less' }).click();
    await expect(id(page, 'plant-thumbwheel')).toHaveAttribute('data-value', '0234');
  });
});

test.describe('car park', () => {
  test.use({ example: 'car-park' });
  test('a car that goes in takes a place', async ({ page }) => {
    await open(page);
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '0050');
    for (const bit of [0, 1, 0, 1]) {
      const before = await id(page, `plant-switch_0_${bit}`).getAttribute('data-on');
      await id(page, `plant-switch_0_${bit}`).click();
      await is(page, `switch_0_${bit}`, before === '1' ? 0 : 1);
    }
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '0049');
    await id(page, 'plant-switch_0_4').hover();
    await expect(id(page, 'plant-picture')).toContainText('I 0.4 Ticket = 0');
  });
});

test.describe('elevator', () => {
  test.use({ example: 'elevator', further: ['--speed', '3x'] });
  test('it comes when it is called; the door waits for the light barrier', async ({ page }) => {
    await open(page);
    await expect(sentence(page)).toContainText('The car is at floor 1.');
    await press(page, 'plant-call_3', 300);
    await is(page, 'lamp_3', 1);
    await expect(sentence(page)).toContainText(/and goes up\..*Called to: 3\./);
    await expect.poll(async () => Number(await id(page, 'elevator-car').getAttribute('data-position'))).toBeGreaterThan(2);
    await expect(sentence(page)).toContainText('The car is at floor 3.');
    await is(page, 'floor_3', 1);
    await id(page, 'plant-barrier').click();
    await is(page, 'barrier', 1);
    await expect(sentence(page)).toContainText('Something is in the light barrier.');
    await is(page, 'door_open', 1);
    await expect(sentence(page)).toContainText('The door is open.');
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '03');
    await id(page, 'plant-emergency').focus();
    await page.keyboard.press('Enter');
    await is(page, 'emergency', 0);
    await is(page, 'alarm', 1);
    await expect(sentence(page)).toContainText('The emergency stop is pressed. The alarm lamp is on.');
  });
});

test.describe('traffic light', () => {
  test.use({ example: 'traffic-light', further: ['--speed', '2.5x'] });
  test('the lights follow the program, and who walks has pressed the button', async ({ page }) => {
    await open(page);
    const main = id(page, 'light-main');
    await expect(main).toHaveAttribute('data-light', 'green');
    await expect(sentence(page)).toContainText('Main road: green');
    await press(page, 'plant-button', 300);
    await expect(id(page, 'light-walk')).toHaveAttribute('data-light', 'green', { timeout: 20_000 });
    await expect(main).toHaveAttribute('data-light', 'red');
    await expect(sentence(page)).toContainText('Pedestrians: green');
    await is(page, 'main_red_lit', 1);
    await is(page, 'walk_green', 1);
    await expect(main).toHaveAttribute('data-light', 'green', { timeout: 20_000 });
    await expect(id(page, 'conflict')).toHaveCount(0);
  });
});

test.describe('heater', () => {
  // Slow enough for a busy computer: its organization block of 100 ms must not be late.
  test.use({ example: 'heater', further: ['--speed', '0.4x'] });
  test('it is heated when it is switched on', async ({ page }) => {
    await open(page);
    await expect(sentence(page)).toContainText('It has 20.0 °C, not changing.');
    await is(page, 'thermostat', 1);
    await toggle(page, '8.0');
    await expect.poll(async () => Number(await id(page, 'plant-heat').getAttribute('data-value')), { timeout: 20_000 }).toBeGreaterThan(50);
    await expect(sentence(page)).toContainText('rising by', { timeout: 20_000 });
    await expect.poll(async () => Number.parseFloat((await id(page, 'temperature').textContent()) ?? ''), { timeout: 20_000 }).toBeGreaterThan(21);
    await expect(id(page, 'in-IW0')).toContainText(/2\d\.\d °C/);
  });
});

test.describe('packing', () => {
  test.use({ example: 'packing', further: ['--speed', '5x'] });
  test('parts come by themselves, are weighed and delivered', async ({ page }) => {
    await open(page);
    await toggle(page, '8.0');
    await expect(sentence(page)).toContainText('The belt runs to the right at 0.50 m/s.');
    await expect.poll(async () => Number(await id(page, 'delivered').textContent())).toBeGreaterThan(1);
    // A part is on the scale for a moment only: each frame is looked at.
    const weighed = () => Number(document.querySelector('[data-testid=plant-weight]')?.getAttribute('data-value')) > 400;
    await page.waitForFunction(weighed, undefined, { polling: 'raf', timeout: 20_000 });
  });
});

test('the past is looked at, not operated; pictures show its scan', async ({ page }) => {
  await open(page);
  await press(page, 'plant-start');
  await expect.poll(async () => Number.parseFloat((await id(page, 'vessel').textContent()) ?? '')).toBeGreaterThan(3);
  await id(page, 'timeline-track').focus();
  await page.keyboard.press('Home');
  await expect(id(page, 'connection')).toHaveText('Past');
  await expect(id(page, 'vessel')).toHaveText('0.0 l');
  await expect(sentence(page)).toContainText('The valve is shut.');
  await expect(id(page, 'plant-start')).toHaveAttribute('aria-disabled', 'true');
  await expect(id(page, 'plant-fault')).toBeDisabled();
  await press(page, 'plant-start');
  await is(page, 'start', 0);
});

for (const example of ['dosing', 'tank', 'star-delta', 'conveyor', 'decade-switches', 'car-park', 'elevator', 'heater', 'packing', 'traffic-light'])
  test.describe(example, () => {
    // Its interrupts come late on a machine that is busy.
    test.use({ example, further: example === 'heater' ? ['--speed', '0.4x'] : [] });
    test('on a phone its picture fits, and what is pressed is large enough', async ({ page }) => {
      await page.setViewportSize({ width: 390, height: 844 });
      await open(page);
      await expect(id(page, 'plant-picture').first()).toBeVisible();
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
      const small = () => page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>('.plant button, .plant [role=button], .plant [role=switch], .rack-panel button, .rack-panel input')]
          .filter((node) => node.closest('[popover]') === null)
          .map((node) => [node, node.getBoundingClientRect()] as const)
          .filter(([, box]) => box.width > 0 && (box.width < 43.5 || box.height < 43.5))
          .map(([node, box]) => `${node.dataset['testid'] ?? node.className} ${Math.round(box.width)}×${Math.round(box.height)}`),
      );
      await expect.poll(small).toEqual([]);
    });
  });

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });
  test('84: water stands still while it flows', async ({ page }) => {
    await open(page);
    await press(page, 'plant-start');
    await is(page, 'valve', 1);
    const offsets = () => id(page, 'plant-picture').locator('[stroke-dashoffset]').evaluateAll((nodes) => nodes.map((node) => node.getAttribute('stroke-dashoffset')));
    const before = await offsets();
    expect(before.length).toBeGreaterThan(0);
    await page.waitForTimeout(700);
    expect(await offsets()).toEqual(before);
  });
});

test('the rack: free channels, units, what is forced, and keys', async ({ page }) => {
  await open(page);
  await expect(id(page, 'in-0.2')).toBeVisible();
  await expect(id(page, 'in-0.7').getByRole('switch')).toHaveCount(0);
  await expect(id(page, 'out-QW4')).toHaveAttribute('data-value', '0000');
  await page.request.post(`${new URL(page.url()).origin}/api/v1/forces`, { data: { name: 'I 0.7', value: '1', reason: 'test' } });
  await expect(id(page, 'in-0.7')).toContainText('forced');
  await expect(id(page, 'terminal-0.7')).toHaveText('Terminal has 0');
  await expect(id(page, 'in-0.7')).toHaveAttribute('data-on', '1');
  await id(page, 'in-0.1').getByRole('switch').focus();
  await page.keyboard.press('t');
  await expect(id(page, 'in-0.1')).toHaveAttribute('data-on', '0');
  await page.keyboard.press('ArrowUp');
  await expect(id(page, 'in-0.0').getByRole('button')).toBeFocused();
  await page.keyboard.down('Space');
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '1');
  await page.keyboard.up('Space');
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '0');
  await page.setViewportSize({ width: 1280, height: 720 });
  await expect(id(page, 'in-0.2')).toBeHidden();
  await expect(id(page, 'in-0.1')).toBeVisible();
});

test.describe('rack of the car park', () => {
  test.use({ example: 'car-park' });
  test('a word that no plant drives is written as a number', async ({ page }) => {
    await open(page);
    const field = id(page, 'in-IW2').getByRole('textbox');
    await field.fill('12');
    await field.press('Enter');
    await expect(id(page, 'in-IW2')).toHaveAttribute('data-value', '12');
    await toggle(page, '1.0');
    await expect(id(page, 'plant-display')).toHaveAttribute('data-value', '0038');
    await field.fill('many');
    await field.press('Enter');
    await expect(id(page, 'toast')).toContainText('whole number');
  });
});
