"""Pages in Debian's Chromium, which draws by software. The tests of the viewer and its figures share it."""
import io
import os
import pathlib

from matplotlib.image import imread
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # containers run as root
    "--disable-dev-shm-usage",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--hide-scrollbars",
    "--force-device-scale-factor=1",
    "--disable-background-networking",
)


class Browser:
    """A page of the viewer in a browser of its own."""

    def __init__(self, width=1400, height=900):
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for option in (*OPTIONS, f"--window-size={width},{height}"):
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver", log_path=os.devnull), options=options)
        self.driver.set_script_timeout(300)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def open(self, page):
        """Opens a page, and waits until it shows its first frame."""
        self.driver.get(pathlib.Path(page).absolute().as_uri())
        self.run("await window.viewerReady")

    def run(self, script, *arguments):
        """The result of the body of an asynchronous function, in which `a` are the arguments."""
        code = f"""const a = [...arguments], done = a.pop();
            (async () => {{ {script} }})().then(
              (value) => done([value, null]), (error) => done([null, error.stack]));"""
        result, problem = self.driver.execute_async_script(code, *arguments)
        if problem:
            raise AssertionError(problem)
        return result

    def dark(self, is_dark):
        """Whether the system of the user is dark, which pages follow that are opened later."""
        feature = {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})

    def screenshot(self):
        """What the page looks like, once it is drawn: rows of pixels r, g, b from 0 to 255."""
        self.run("await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)))")
        return 255 * imread(io.BytesIO(self.driver.get_screenshot_as_png()))[:, :, :3]

    def element(self, name):
        return self.driver.find_element(By.ID, name)

    def click(self, x, y):
        self.pointer().move_by_offset(round(x), round(y)).click().perform()
        self.pointer()

    def drag(self, x, y, dx, dy):
        self.pointer().move_by_offset(round(x), round(y)).click_and_hold().move_by_offset(dx, dy).release().perform()

    def pointer(self):
        """The pointer in the upper left corner of the page."""
        chain = ActionChains(self.driver, duration=20)
        chain.w3c_actions.pointer_action.move_to_location(0, 0)
        return chain

    def type(self, keys):
        ActionChains(self.driver).send_keys(keys).perform()

    def problems(self):
        """Errors and warnings in the console since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def fetched(self):
        """What the page has fetched besides itself."""
        return self.run("return performance.getEntriesByType('resource').map((entry) => entry.name)")
