import { describe, expect, it } from 'vitest';
import { readEvents, takeEvents, type ServerEvent } from '../src/logic/events';

describe('server-sent events', () => {
  it('are taken whole; the rest waits', () => {
    expect(takeEvents('event: job\ndata: {"a":1}\n\n:\n\nid: 3\ndata: x\ndata: y\n\nevent: jo')).toEqual({
      events: [{ name: 'job', data: '{"a":1}' }, { name: 'message', data: 'x\ny' }],
      rest: 'event: jo',
    });
  });
  it('survive being cut anywhere, also inside a letter', async () => {
    const text = 'event: job\ndata: {"title":"Токарний"}\n\nevent: job\r\ndata: 2\r\n\r\n';
    const bytes = new TextEncoder().encode(text);
    for (const size of [1, 2, 3, 7, 1000]) {
      const events: ServerEvent[] = [];
      const body = new ReadableStream<Uint8Array>({
        start(controller) {
          for (let k = 0; k < bytes.length; k += size) controller.enqueue(bytes.slice(k, k + size));
          controller.close();
        },
      });
      await readEvents(body, (e) => events.push(e));
      expect(events.map((e) => e.data), `pieces of ${size}`).toEqual(['{"title":"Токарний"}', '2']);
    }
  });
});
