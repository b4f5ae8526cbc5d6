// Questions to the server and its answers. Of equal questions only the newest is sure to be answered.

export class Channel {
  constructor(address) {
    this.address = address;
    this.waiting = new Map(); // by kind of question: the questions under way, by number
    this.number = 0;
    this.onstate = () => {};
    this.opened = new Promise((resolve) => { this.greeted = resolve; });
    this.connect();
  }

  connect() {
    this.socket = new WebSocket(this.address);
    this.socket.binaryType = "arraybuffer";
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = () => {
      this.onstate(false);
      for (const under of this.waiting.values()) for (const done of under.values()) done(null);
      this.waiting.clear();
      setTimeout(() => this.connect(), 2000);
    };
  }

  take(data) {
    const [answer, content] = typeof data === "string" ? [JSON.parse(data)] : opened(data);
    if (answer.do === "hello") {
      this.greeted(answer);
      this.onstate(true);
      return;
    }
    const under = this.waiting.get(kindOf(answer)) ?? this.waiting.get(answer.do);
    if (!under) return;
    const done = under.get(answer.id);
    for (const [number, overtaken] of under) {
      if (number > answer.id) break;
      under.delete(number);
      if (number < answer.id) overtaken(null);
    }
    done?.(content ? { ...answer, content } : answer);
  }

  // The answer; null where a newer question overtook this one or the server has gone.
  ask(question) {
    const id = ++this.number;
    if (this.socket.readyState !== WebSocket.OPEN) return Promise.resolve(null);
    const kind = kindOf(question);
    if (!this.waiting.has(kind)) this.waiting.set(kind, new Map());
    return new Promise((resolve) => {
      this.waiting.get(kind).set(id, resolve);
      this.socket.send(JSON.stringify({ ...question, id }));
    });
  }
}

const kindOf = (question) => `${question.do} ${question.kind ?? ""}`.trim();

function opened(buffer) {
  const bytes = new Uint8Array(buffer), end = bytes.indexOf(10);
  return [JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))), bytes.subarray(end + 1)];
}
