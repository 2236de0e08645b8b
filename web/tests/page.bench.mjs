// How long the built page takes: `npm run bench`. Each line is <question>/<strategy>/<case> and milliseconds; a busy machine
// makes them larger, so nothing is asserted.
import { closeBrowser, open } from "./browser.mjs";

const site = await open();
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const line = (name, times) => {
    const sorted = times.slice().sort((a, b) => a - b);
    const at = (part) => sorted[Math.floor((sorted.length - 1) * part)].toFixed(2).padStart(9);
    console.log(`${name.padEnd(44)} median ${at(0.5)} ms   slowest ${at(1)} ms   of ${sorted.length}`);
};

/** The rear neighbour dragged in and out; what each frame took to answer. */
async function drag(name, path) {
    const page = await site.page({ path });
    await page.evaluate(() => (window.snugPage.frameTimes.length = 0));
    const grip = await page.locator('#drawing [data-grip="rear"] .knob').boundingBox();
    const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let step = 0; step <= 60; ++step) {
        await page.mouse.move(x + 60 * Math.sin(step / 6), y);
        await settled(page);
    }
    line(name, await page.evaluate(() => window.snugPage.frameTimes));
    await page.mouse.up();
    await page.context().close();
}

/** From the navigation to the first answer. */
async function load(name) {
    const times = [];
    for (let i = 0; i < 5; ++i) {
        const page = await site.page();
        times.push(Number(await page.evaluate(() => document.documentElement.dataset.ready)));
        await page.context().close();
    }
    line(name, times);
}

/**
 * The car driven about the street: what each look into a map took, by the page itself and by a worker there and back; after the
 * car is put down how long the proof takes; the maps themselves, and the answer where the car stands after a neighbour moved.
 */
async function street(name, path) {
    const page = await site.page({ path });
    await page.waitForFunction(() => window.snugPage.map.state()?.finest);
    await page.evaluate(() => window.snugPage.map.sweepOwn());
    const grip = await page.locator('#street [data-grip="car"] .reach').boundingBox();
    const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
    await page.evaluate(() => (window.snugPage.map.times.looks.length = 0));
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let step = 0; step <= 60; ++step) {
        await page.mouse.move(x - 60 + 60 * Math.cos(step / 6), y + 30 * Math.sin(step / 6));
        await settled(page);
    }
    await page.mouse.up();
    const since = (what) =>
        page.evaluate(
            (what) =>
                new Promise((done) => {
                    const begin = performance.now();
                    const { map, parking, answer } = window.snugPage;
                    const is = { proof: () => answer(), bounds: () => map.state().current && parking.bounds && parking.lookedAt === parking.pose }[what];
                    const wait = () => (is() ? done(performance.now() - begin) : requestAnimationFrame(wait));
                    wait();
                }),
            what,
        );
    line(`${name}/proof-after-drop`, [await since("proof")]);
    line(`${name}/look-and-maneuver/in-the-frame`, await page.evaluate(() => window.snugPage.map.times.own));
    line(`${name}/look-and-maneuver/by-a-worker`, await page.evaluate(() => window.snugPage.map.times.looks));
    await page.locator('#street [data-grip="rear"]').focus();
    const moved = [];
    for (let i = 0; i < 8; ++i) {
        await page.keyboard.press("ArrowUp");
        moved.push(await since("bounds"));
    }
    line(`${name}/answer-after-a-neighbour-moved`, moved);
    line(`${name}/first-map`, await page.evaluate(() => window.snugPage.map.times.maps));
    await page.context().close();
}

await load("page/load/first-answer");
await drag("page/max-steer/drag-ordinary-slots", "#mode=entry");
await drag("page/max-steer/drag-tight-slots", "#car=renault-zoe&length=4.9&width=1.85");
await street("page/street/parallel", "#mode=street");
await street("page/street/perpendicular", "#mode=street&angle=90&length=5&width=2.5");
await site.close();
await closeBrowser();
