"""A headless Chromium, driven by the DevTools protocol through a pipe: no driver, and no package of Python for it."""

import base64
import fcntl
import io
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

from PIL import Image

NAMES = ['chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome']
FLAGS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
         '--disable-background-networking', '--disable-component-update', '--disable-sync',
         '--enable-unsafe-swiftshader', '--hide-scrollbars', '--force-color-profile=srgb', '--remote-debugging-pipe']
PATIENCE = 120  # seconds for an answer


def find_browser():
    """The program, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One window. Remembers what pages ask for and complain about."""

    def __init__(self, *flags):
        self.profile = tempfile.TemporaryDirectory(prefix='quadtree_mesh_2_', ignore_cleanup_errors=True)
        to_browser, self.out = os.pipe()
        self.incoming, from_browser = os.pipe()

        def take_pipes():
            # The protocol is on descriptors 3 and 4, on which others may be.
            high = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (to_browser, from_browser)]
            for target, source in zip((3, 4), high):
                os.dup2(source, target)

        self.process = subprocess.Popen(
            [find_browser(), *FLAGS, '--user-data-dir=' + self.profile.name, *flags], close_fds=False,
            preexec_fn=take_pipes, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.rest, self.last_id, self.session = b'', 0, None
        self.requests, self.complaints = [], []
        target = self.send('Target.createTarget', url='about:blank')['targetId']
        self.session = self.send('Target.attachToTarget', targetId=target, flatten=True)['sessionId']
        for domain in ('Page', 'Runtime', 'Log', 'Network'):
            self.send(domain + '.enable')

    def close(self):
        self.process.terminate()
        self.process.wait()
        os.close(self.out)
        os.close(self.incoming)
        self.profile.cleanup()

    def send(self, method, **parameters):
        """Calls a method of the protocol and returns what it answers."""
        self.last_id += 1
        message = {'id': self.last_id, 'method': method, 'params': parameters}
        if self.session:
            message['sessionId'] = self.session
        os.write(self.out, json.dumps(message).encode() + b'\0')
        end = time.monotonic() + PATIENCE
        while True:
            answer = self.read(end)
            if answer.get('id') == self.last_id:
                if 'error' in answer:
                    raise RuntimeError(f'{method}: {answer["error"]["message"]}')
                return answer['result']
            self.remember(answer)

    def read(self, end):
        while b'\0' not in self.rest:
            if not select.select([self.incoming], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError('no answer from the browser')
            piece = os.read(self.incoming, 1 << 20)
            if not piece:
                raise RuntimeError('the browser has ended')
            self.rest += piece
        message, _, self.rest = self.rest.partition(b'\0')
        return json.loads(message)

    def remember(self, event):
        parameters = event.get('params', {})
        if event.get('method') == 'Network.requestWillBeSent':
            self.requests.append(parameters['request']['url'])
        elif event.get('method') == 'Runtime.exceptionThrown':
            self.complaints.append(str(parameters['exceptionDetails']))
        elif event.get('method') == 'Log.entryAdded' and parameters['entry']['source'] != 'rendering':  # by WebGL
            self.complaints.append(str(parameters['entry']))
        elif event.get('method') == 'Runtime.consoleAPICalled':
            self.complaints.append(str(parameters))

    def open(self, path, mark='', size=(1200, 800), is_mobile=False):
        """Opens a page anew and waits until it has drawn; returns the seconds that takes."""
        self.send('Emulation.setDeviceMetricsOverride', width=size[0], height=size[1], deviceScaleFactor=1,
                  mobile=is_mobile)
        self.send('Emulation.setTouchEmulationEnabled', enabled=is_mobile)
        self.send('Page.navigate', url='about:blank')
        self.requests.clear()
        begin = time.monotonic()
        self.send('Page.navigate', url='file://' + os.path.abspath(path) + mark)
        while not self.evaluate('document.documentElement && document.documentElement.dataset.ready == "yes"'):
            if time.monotonic() > begin + PATIENCE:
                raise TimeoutError(f'the page draws nothing: {self.complaints}')
            time.sleep(0.02)
        return time.monotonic() - begin

    def evaluate(self, script):
        """The value of an expression, awaited."""
        answer = self.send('Runtime.evaluate', expression=script, returnByValue=True, awaitPromise=True)
        if 'exceptionDetails' in answer:
            raise RuntimeError(str(answer['exceptionDetails']))
        return answer['result'].get('value')

    def text(self, selector):
        """The text of an element; None if it is not shown."""
        return self.evaluate('(e => e && e.checkVisibility() ? e.textContent : null)'
                             f'(document.querySelector({json.dumps(selector)}))')

    def settle(self):
        """Waits until what has changed is drawn."""
        self.evaluate('new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))')

    def picture(self):
        self.settle()
        data = base64.b64decode(self.send('Page.captureScreenshot', format='png')['data'])
        return Image.open(io.BytesIO(data)).convert('RGB')

    def move(self, x, y):
        self.send('Input.dispatchMouseEvent', type='mouseMoved', x=x, y=y)

    def drag(self, start, end):
        self.move(*start)
        self.send('Input.dispatchMouseEvent', type='mousePressed', x=start[0], y=start[1], button='left', clickCount=1)
        for share in (0.5, 1):
            at = [a + share * (b - a) for a, b in zip(start, end)]
            self.send('Input.dispatchMouseEvent', type='mouseMoved', x=at[0], y=at[1], button='left', buttons=1)
        self.send('Input.dispatchMouseEvent', type='mouseReleased', x=end[0], y=end[1], button='left', clickCount=1)

    def wheel(self, x, y, pixels):
        self.send('Input.dispatchMouseEvent', type='mouseWheel', x=x, y=y, deltaX=0, deltaY=pixels)

    def touch(self, kind, *places):
        self.send('Input.dispatchTouchEvent', type='touch' + kind,
                  touchPoints=[{'x': x, 'y': y, 'id': i} for i, (x, y) in enumerate(places)])

    def key(self, key):
        self.send('Input.dispatchKeyEvent', type='keyDown', key=key, text=key if len(key) == 1 else '')
        self.send('Input.dispatchKeyEvent', type='keyUp', key=key)

    def click(self, selector):
        """Clicks on the middle of an element, as a mouse does."""
        x, y = self.evaluate(f'(r => [r.x + r.width / 2, r.y + r.height / 2])'
                             f'(document.querySelector({json.dumps(selector)}).getBoundingClientRect())')
        self.move(x, y)
        for kind in ('mousePressed', 'mouseReleased'):
            self.send('Input.dispatchMouseEvent', type=kind, x=x, y=y, button='left', clickCount=1)

    def choose(self, selector, value):
        """Chooses from a menu, as its `change` tells the page."""
        self.evaluate(f'(e => {{ e.value = {json.dumps(value)}; e.dispatchEvent(new Event("change")); }})'
                      f'(document.querySelector({json.dumps(selector)}))')
