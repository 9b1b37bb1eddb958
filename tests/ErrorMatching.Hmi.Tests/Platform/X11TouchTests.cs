using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Interactivity;
using Avalonia.Layout;
using Avalonia.Media;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Fingers on a real X server's touch screen, through the station's connection, to controls.</summary>
public sealed class X11TouchTests
{
    [Fact]
    public Task A_tap_presses_a_button_once_and_is_no_mouse() => On(1, (seen, screen) =>
    {
        screen.Begin(0, 100, 50);
        seen.Arrive();
        Assert.Equal(["pressed Touch"], seen.Events);
        Assert.Equal(0, seen.Clicks);
        screen.End(0, 100, 50);
        seen.Arrive();
        Assert.Equal(1, seen.Clicks);
        Assert.Equal(["pressed Touch", "released Touch", "lost Touch"], seen.Events);
        screen.Begin(0, 100, 50).End(0, 100, 50);
        seen.Arrive();
        Assert.Equal(2, seen.Clicks);
    });

    [Theory]
    [InlineData(1.0)]
    [InlineData(1.5)]
    public Task Two_fingers_zoom_a_plot_as_far_as_they_part(double scaling) => On(scaling, (seen, screen) =>
    {
        // 20 and then 120 units apart, around the middle.
        var was = seen.Plot.View;
        var (left, right) = (seen.PlotAt(210, 200), seen.PlotAt(230, 200));
        var (outerLeft, outerRight) = (seen.PlotAt(160, 200), seen.PlotAt(280, 200));
        screen.Begin(0, left.X, left.Y).Begin(1, right.X, right.Y);
        seen.Arrive();
        screen.Move(0, outerLeft.X, outerLeft.Y).Move(1, outerRight.X, outerRight.Y);
        seen.Arrive();
        screen.End(0, outerLeft.X, outerLeft.Y).End(1, outerRight.X, outerRight.Y);
        seen.Arrive();
        Assert.Equal(6, seen.Plot.View.ScaleX / was.ScaleX, 3);
        var moved = seen.Plot.View.ToPlot(new(220, 200)).DistanceTo(was.ToPlot(new(220, 200)));
        Assert.True(moved < 1e-3, $"{moved}");
        Assert.DoesNotContain(seen.Events, e => e.EndsWith("Mouse", StringComparison.Ordinal));
    });

    [Fact]
    public Task One_finger_scrolls() => On(1, (seen, screen) =>
    {
        screen.Begin(0, 100, 300);
        seen.Arrive();
        for (var y = 290; y >= 200; y -= 10)
        {
            screen.Move(0, 100, y);
            seen.Arrive();
        }

        // The list follows the finger from where the movement was recognized as scrolling; a finger that rests before it is lifted
        // throws nothing.
        Assert.InRange(seen.Scroller.Offset.Y, 50, 100);
        screen.End(0, 100, 200);
        seen.Arrive();
        Assert.Equal(0, seen.Clicks);
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_window_that_hides_or_closes_lets_go_of_its_fingers(bool isClosed) => On(1, (seen, screen) =>
    {
        screen.Begin(0, 100, 50).Begin(1, 150, 50);
        seen.Arrive();
        (isClosed ? seen.Window.Close : (Action)seen.Window.Hide)();
        seen.Arrive();
        Assert.Equal(["pressed Touch", "pressed Touch", "lost Touch", "lost Touch"], seen.Events);
        screen.End(0, 100, 50).End(1, 150, 50);
        seen.Arrive();
        Assert.Equal((0, 4), (seen.Clicks, seen.Events.Count));
    });

    [Fact]
    public Task A_window_that_loses_the_keyboard_lets_go_of_its_fingers() => On(1, (seen, screen) =>
    {
        XServer.Do("search", "--name", Seen.Title, "windowfocus");
        screen.Begin(0, 100, 50);
        seen.Arrive();
        using (var other = new X11Window(1))
        {
            other.SetTitle("other");
            other.Show(activate: true, isDialog: false);
            XServer.Do("search", "--name", "other", "windowfocus");
            seen.Arrive();
            Assert.Equal(["pressed Touch", "lost Touch"], seen.Events);
        }

        screen.End(0, 100, 50);
        seen.Arrive();
        Assert.Equal((0, 2), (seen.Clicks, seen.Events.Count));
    });

    [Fact]
    public Task A_mouse_remains_a_mouse() => On(1, (seen, _) =>
    {
        XServer.Do("mousemove", "100", "50", "mousedown", "1", "mousemove", "102", "50", "mouseup", "1");
        seen.Arrive();
        Assert.Equal(1, seen.Clicks);
        Assert.Equal(["moved Mouse", "pressed Mouse", "moved Mouse", "released Mouse", "lost Mouse"], seen.Events);
    });

    [Theory]
    [InlineData(1.0, 350, 301)]
    [InlineData(1.1, 385, 331)]
    [InlineData(1.5, 525, 451)]
    public Task The_window_manager_is_told_the_least_size_in_pixels(double scaling, int width, int height) => On(scaling, (seen, _) =>
    {
        (seen.Window.MinWidth, seen.Window.MinHeight) = (350, 300.4);
        var hints = XServer.Property(Seen.Title, "WM_NORMAL_HINTS");

        // ICCCM 4.1.2.3: flags, of which 16 means that the least size is given, then four fields of old, then that size.
        Assert.Equal((16, width, height), (hints[0], hints[5], hints[6]));
    });

    [Fact]
    public unsafe void What_a_finger_did_is_read_from_the_layout_of_the_protocol()
    {
        // XIDeviceEvent of XInput2.h for 64 bits, as a C compiler lays it out: evtype at 36, detail at 56, event at 72, event_x at 104,
        // event_y at 112, flags at 120, buttons.mask_len at 128, buttons.mask at 136, mods.effective at 180.
        var memory = new byte[192];
        BitConverter.TryWriteBytes(memory.AsSpan(36), 19);
        BitConverter.TryWriteBytes(memory.AsSpan(56), 7);
        BitConverter.TryWriteBytes(memory.AsSpan(72), 0x400001L);
        BitConverter.TryWriteBytes(memory.AsSpan(104), 12.5);
        BitConverter.TryWriteBytes(memory.AsSpan(112), 3.25);
        BitConverter.TryWriteBytes(memory.AsSpan(120), 1 << 16);
        Assert.Equal(new XInputEvent(0x400001, 19, 7, 12.5, 3.25, 0, true), Decode(memory));
        BitConverter.TryWriteBytes(memory.AsSpan(120), 1 << 17);
        Assert.Equal(new XInputEvent(0x400001, 19, 7, 12.5, 3.25, 0, false), Decode(memory));

        // A movement of the mouse, with Shift, Ctrl and the buttons 1 and 3.
        var buttons = (byte*)NativeMemory.AllocZeroed(4);
        buttons[0] = (1 << 1) | (1 << 3);
        BitConverter.TryWriteBytes(memory.AsSpan(36), 6);
        BitConverter.TryWriteBytes(memory.AsSpan(56), 0);
        BitConverter.TryWriteBytes(memory.AsSpan(128), 4);
        BitConverter.TryWriteBytes(memory.AsSpan(136), (long)buttons);
        BitConverter.TryWriteBytes(memory.AsSpan(180), 1 | 4);
        Assert.Equal(new XInputEvent(0x400001, 6, 0, 12.5, 3.25, 1 | 4 | 0x100 | 0x400, false), Decode(memory));
        NativeMemory.Free(buttons);

        // A button, which the core protocol reports.
        BitConverter.TryWriteBytes(memory.AsSpan(36), 4);
        Assert.Null(Decode(memory));

        static XInputEvent? Decode(byte[] memory) =>
            X11Pointing.Decode(in MemoryMarshal.AsRef<XInput.DeviceEvent>(memory));
    }

    [Fact]
    public void A_finger_is_passed_on_from_its_beginning_to_its_end_in_units()
    {
        var passed = new List<(RawPointerEventType, Point, long)>();
        var fingers = new X11Fingers(2, (type, at, finger) => passed.Add((type, at, finger)));
        fingers.On(new(1, XInput.TouchUpdate, 4, 8, 8, 0, false));
        fingers.On(new(1, XInput.TouchEnd, 4, 8, 8, 0, false));
        Assert.Empty(passed);

        fingers.On(new(1, XInput.TouchBegin, 5, 10, 20, 0, false));
        fingers.On(new(1, XInput.TouchUpdate, 5, 30, 20, 0, false));
        fingers.On(new(1, XInput.TouchUpdate, 5, 90, 90, 0, true));
        fingers.On(new(1, XInput.TouchEnd, 5, 32, 20, 0, false));
        fingers.On(new(1, XInput.TouchUpdate, 5, 34, 20, 0, false));
        Assert.Equal(
            [
                (RawPointerEventType.TouchBegin, new(5, 10), 5), (RawPointerEventType.TouchUpdate, new(15, 10), 5),
                (RawPointerEventType.TouchEnd, new(16, 10), 5),
            ],
            passed);

        // Another client gets the finger.
        passed.Clear();
        fingers.On(new(1, XInput.TouchBegin, 6, 2, 2, 0, false));
        fingers.On(new(1, XInput.TouchEnd, 6, 2, 2, 0, true));
        Assert.Equal([(RawPointerEventType.TouchBegin, new(1, 1), 6), (RawPointerEventType.TouchCancel, new(1, 1), 6)], passed);

        // Canceled where it was last; what follows until it is lifted is ignored.
        passed.Clear();
        fingers.On(new(1, XInput.TouchBegin, 7, 2, 2, 0, false));
        fingers.On(new(1, XInput.TouchUpdate, 7, 6, 6, 0, false));
        fingers.Cancel();
        fingers.On(new(1, XInput.TouchUpdate, 7, 8, 8, 0, false));
        fingers.On(new(1, XInput.TouchEnd, 7, 8, 8, 0, false));
        fingers.Cancel();
        Assert.Equal((RawPointerEventType.TouchCancel, new(3, 3), 7), passed[^1]);
        Assert.Equal(3, passed.Count);
    }

    private static async Task On(double scaling, Action<Seen, TouchScreen> test)
    {
        var session = Drawing.Needed();
        XServer.TouchPresent();
        XServer.Present("xdotool");
        await session.RunAsync(() =>
        {
            XServer.Connect();
            var advised = new List<string>();
            var seen = new Seen(scaling, advised.Add);
            try
            {
                Assert.Empty(advised);
                test(seen, XServer.Touched);
            }
            finally
            {
                XServer.Touched.LiftAll();
                seen.Window.Close();
            }
        });
    }

    // A button above a list that scrolls, beside a plot. Events are those that the window sees, without movements.
    private sealed class Seen
    {
        public const string Title = "touched";

        private readonly double _scaling;
        private readonly ScreenUser _user;

        public Seen(double scaling, Action<string> advise)
        {
            _scaling = scaling;
            Texts.Current.Language = Language.English;
            var button = new Button { Content = "press", Width = 200, Height = 100 };
            button.Click += (_, _) => Clicks++;
            Scroller = new ScrollViewer { Content = new Border { Height = 2000, Background = Brushes.Gray }, Height = 300, Width = 200 };
            Plot = new GapPlot { Drawing = PlotAreaTests.Gap(), Width = 440, Height = 400 };
            var left = new StackPanel { Children = { button, Scroller } };
            Window = new Window(new X11Window(scaling, advise))
            {
                Title = Title,
                Width = 640,
                Height = 400,
                Content = new StackPanel { Orientation = Orientation.Horizontal, Children = { left, Plot } },
            };
            Window.AddHandler(InputElement.PointerPressedEvent, Add("pressed"), RoutingStrategies.Tunnel);
            Window.AddHandler(InputElement.PointerReleasedEvent, Add("released"), RoutingStrategies.Tunnel);
            button.PointerCaptureLost += (_, e) => Events.Add($"lost {e.Pointer.Type}");
            Window.AddHandler(InputElement.PointerMovedEvent, NoMouse, RoutingStrategies.Tunnel);
            _user = new(Window);
            Window.Show();
            Arrive();
        }

        public Window Window { get; }

        public ScrollViewer Scroller { get; }

        public GapPlot Plot { get; }

        public int Clicks { get; private set; }

        public List<string> Events { get; } = [];

        // Pixels of the screen; without a window manager, the window is in its corner.
        public Point PlotAt(double x, double y) => Avalonia.VisualExtensions.TranslatePoint(Plot, new(x, y), Window)!.Value * _scaling;

        public void Arrive()
        {
            XServer.Touched.Arrive();
            _user.Settle();
        }

        private EventHandler<PointerEventArgs> Add(string what) => (_, e) => Events.Add($"{what} {e.Pointer.Type}");

        private void NoMouse(object? sender, PointerEventArgs e)
        {
            if (e.Pointer.Type == PointerType.Mouse)
            {
                Events.Add("moved Mouse");
            }
        }
    }
}
