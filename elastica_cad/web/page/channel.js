// Questions to the core and its answers. Of equal questions only the newest is sure to be answered.

class Questions {
  constructor() {
    this.waiting = new Map(); // by kind of question: the questions under way, by number
    this.number = 0;
    this.onstate = () => {};
  }

  take(answer, content) {
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

  // The answer; null where a newer question overtook this one or nobody is there.
  ask(question) {
    const id = ++this.number, kind = kindOf(question);
    if (!this.open) return Promise.resolve(null);
    if (!this.waiting.has(kind)) this.waiting.set(kind, new Map());
    return new Promise((resolve) => {
      this.waiting.get(kind).set(id, resolve);
      this.send({ ...question, id });
    });
  }
}

const WRONG_KEY = 1008;

// To the server of the page, which answers after it has received the key. `opened` has its greeting, or null if the key is wrong.
export class Channel extends Questions {
  constructor(address, key) {
    super();
    Object.assign(this, { address, key });
    this.opened = new Promise((resolve) => { this.greeted = resolve; });
    this.connect();
  }

  get open() { return this.socket.readyState === WebSocket.OPEN; }

  send(question) { this.socket.send(JSON.stringify(question)); }

  connect() {
    this.socket = new WebSocket(this.address);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => this.socket.send(this.key);
    this.socket.onmessage = ({ data }) => {
      const [answer, content] = typeof data === "string" ? [JSON.parse(data)] : opened(data);
      if (answer.do !== "hello") this.take(answer, content);
      else {
        this.greeted(answer);
        this.onstate(true, answer);
      }
    };
    this.socket.onclose = ({ code }) => {
      this.onstate(false);
      for (const under of this.waiting.values()) for (const done of under.values()) done(null);
      this.waiting.clear();
      if (code === WRONG_KEY) this.greeted(null); // the server is another one than at the time of the key
      else setTimeout(() => this.connect(), 2000);
    };
  }
}

// To the kernel of a notebook, which answers one after the other: a question that is overtaken is never sent.
export class KernelChannel extends Questions {
  constructor(model) {
    super();
    Object.assign(this, { model, open: true, busy: false, next: new Map() });
    model.on("msg:custom", (answer, [content]) => {
      this.busy = false;
      this.take(answer, content && new Uint8Array(content.buffer ?? content));
      const [kind, question] = this.next.entries().next().value ?? [];
      this.next.delete(kind);
      if (question) this.send(question);
    });
  }

  send(question) {
    if (this.busy) this.next.set(kindOf(question), question);
    else this.model.send(question);
    this.busy = true;
  }
}

const kindOf = (question) => `${question.do} ${question.kind ?? ""}`.trim();

function opened(buffer) {
  const bytes = new Uint8Array(buffer), end = bytes.indexOf(10);
  return [JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))), bytes.subarray(end + 1)];
}
