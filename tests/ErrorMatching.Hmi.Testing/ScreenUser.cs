using System.Diagnostics;
using System.Runtime.ExceptionServices;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Testing;

/// <summary>A simulated user of a window without a screen: moves, taps, types, presses keys, looks. Each method returns only after layout,
/// bindings and one frame.</summary>
/// <param name="window">The window. It must have been opened under <see cref="OffScreenPlatform.UseOffScreen"/>.</param>
public sealed class ScreenUser(Window window)
{
    /// <summary>Milliseconds between two keys of a fast hand.</summary>
    public const ulong ByHandMs = 90;

    private OffScreenWindow Platform => (OffScreenWindow)window.PlatformImpl!;

    /// <summary>Completes all pending work, and draws it.</summary>
    public ScreenUser Settle(int frames = 2)
    {
        OffScreenClock.Current.Advance(frames);
        return this;
    }

    /// <summary>Lets real time pass: transitions and timers follow the real clock, not the frames. Frames are drawn before keys and taps
    /// are processed, as on a screen.</summary>
    public ScreenUser Wait(TimeSpan time)
    {
        var watch = Stopwatch.StartNew();
        return WaitFor(() => watch.Elapsed >= time, TimeSpan.MaxValue, DispatcherPriority.Render);
    }

    /// <summary>Lets time pass until a condition is met.</summary>
    /// <exception cref="TimeoutException">The condition was not met in time.</exception>
    public ScreenUser WaitFor(Func<bool> condition, TimeSpan most)
    {
        ArgumentNullException.ThrowIfNull(condition);
        Settle();
        return condition() ? this : WaitFor(condition, most, DispatcherPriority.Background);
    }

    /// <summary>Moves the pointer to the middle of a control.</summary>
    public ScreenUser MoveTo(Visual target) => MoveTo(target, Middle(target));

    /// <summary>Moves the pointer to a position in a control, from its upper left corner.</summary>
    public ScreenUser MoveTo(Visual target, Point place)
    {
        Settle();
        Platform.Mouse(RawPointerEventType.Move, InWindow(target, place), RawInputModifiers.None);
        return Settle();
    }

    /// <summary>Presses and releases the left button in the middle of a control.</summary>
    public ScreenUser Click(Visual target) => Click(target, Middle(target));

    /// <summary>Presses and releases the left button at a position in a control, from its upper left corner.</summary>
    public ScreenUser Click(Visual target, Point place) => Drag(target, place, place);

    /// <summary>Presses the left button in the middle of a control, runs an action, and releases the button there or at an
    /// offset.</summary>
    public ScreenUser Hold(Visual target, Action meanwhile, Vector further = default)
    {
        ArgumentNullException.ThrowIfNull(meanwhile);
        var at = InWindow(target, Middle(target));
        MoveTo(target);
        Platform.Mouse(RawPointerEventType.LeftButtonDown, at, RawInputModifiers.LeftMouseButton);
        Settle();
        meanwhile();
        Platform.Mouse(RawPointerEventType.Move, at + further, RawInputModifiers.LeftMouseButton);
        Settle();
        Platform.Mouse(RawPointerEventType.LeftButtonUp, at + further, RawInputModifiers.None);
        return Settle();
    }

    /// <summary>Presses the left button at one position in a control and releases it at another.</summary>
    public ScreenUser Drag(Visual target, Point from, Point to)
    {
        MoveTo(target, from);
        Platform.Mouse(RawPointerEventType.LeftButtonDown, InWindow(target, from), RawInputModifiers.LeftMouseButton);
        Settle();
        if (from != to)
        {
            Platform.Mouse(RawPointerEventType.Move, InWindow(target, (from + to) / 2), RawInputModifiers.LeftMouseButton);
            Platform.Mouse(RawPointerEventType.Move, InWindow(target, to), RawInputModifiers.LeftMouseButton);
            Settle();
        }

        Platform.Mouse(RawPointerEventType.LeftButtonUp, InWindow(target, to), RawInputModifiers.None);
        return Settle();
    }

    /// <summary>Taps the middle of a control with a finger.</summary>
    public ScreenUser Tap(Visual target) => Tap(target, () => { });

    /// <summary>Taps a position in a control with a finger, from its upper left corner.</summary>
    public ScreenUser Tap(Visual target, Point place)
    {
        Settle();
        var at = InWindow(target, place);
        Platform.Touch(RawPointerEventType.TouchBegin, at);
        Settle();
        Platform.Touch(RawPointerEventType.TouchEnd, at);
        return Settle();
    }

    /// <summary>Touches the middle of a control with a finger, runs an action, and lifts the finger.</summary>
    public ScreenUser Tap(Visual target, Action meanwhile)
    {
        ArgumentNullException.ThrowIfNull(meanwhile);
        Settle();
        var at = InWindow(target, Middle(target));
        Platform.Touch(RawPointerEventType.TouchBegin, at);
        Settle();
        meanwhile();
        Settle();
        Platform.Touch(RawPointerEventType.TouchEnd, at);
        return Settle();
    }

    /// <summary>Puts two fingers on a control, moves both, and lifts them.</summary>
    public ScreenUser Pinch(Visual target, (Point From, Point To) first, (Point From, Point To) second)
    {
        Settle();
        Platform.Touch(RawPointerEventType.TouchBegin, InWindow(target, first.From), 1);
        Platform.Touch(RawPointerEventType.TouchBegin, InWindow(target, second.From), 2);
        Settle();
        Platform.Touch(RawPointerEventType.TouchUpdate, InWindow(target, first.To), 1);
        Platform.Touch(RawPointerEventType.TouchUpdate, InWindow(target, second.To), 2);
        Settle();
        Platform.Touch(RawPointerEventType.TouchEnd, InWindow(target, first.To), 1);
        Platform.Touch(RawPointerEventType.TouchEnd, InWindow(target, second.To), 2);
        return Settle();
    }

    /// <summary>Puts a finger on a control, moves it, and lifts it.</summary>
    public ScreenUser Swipe(Visual target, Point from, Point to)
    {
        Settle();
        Platform.Touch(RawPointerEventType.TouchBegin, InWindow(target, from));
        Settle();
        Platform.Touch(RawPointerEventType.TouchUpdate, InWindow(target, (from + to) / 2));
        Platform.Touch(RawPointerEventType.TouchUpdate, InWindow(target, to));
        Settle();
        Platform.Touch(RawPointerEventType.TouchEnd, InWindow(target, to));
        return Settle();
    }

    /// <summary>Turns the wheel over a control; a positive number of notches scrolls up.</summary>
    public ScreenUser Wheel(Visual target, double notches)
    {
        MoveTo(target);
        Platform.Wheel(InWindow(target, Middle(target)), new Vector(0, notches), RawInputModifiers.None);
        return Settle();
    }

    /// <summary>Types text into the focused control.</summary>
    public ScreenUser Type(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        foreach (var rune in text.EnumerateRunes())
        {
            Platform.Text(rune.ToString(), Now);
        }

        return Settle();
    }

    /// <summary>Types as a hand does, with <see cref="ByHandMs"/> between two keys, and Enter.</summary>
    public ScreenUser TypeByHand(string text)
    {
        Queue(text, ByHandMs);
        return Settle();
    }

    /// <summary>Scans a code: characters 10 ms apart, and Enter.</summary>
    public ScreenUser Scan(string code)
    {
        Queue(code, 10);
        return Settle();
    }

    /// <summary>Presses a button, types by hand and presses Enter, all before the station handles anything, as if it were busy.</summary>
    public ScreenUser ClickAndTypeAhead(Visual target, string text)
    {
        MoveTo(target);
        var at = InWindow(target, Middle(target));
        Platform.Mouse(RawPointerEventType.LeftButtonDown, at, RawInputModifiers.LeftMouseButton);
        Platform.Mouse(RawPointerEventType.LeftButtonUp, at, RawInputModifiers.None);
        Queue(text, ByHandMs);
        return Settle();
    }

    /// <summary>Presses and releases a key.</summary>
    public ScreenUser Press(Key key, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        Platform.Key(RawKeyEventType.KeyDown, key, modifiers, Now);
        Platform.Key(RawKeyEventType.KeyUp, key, modifiers, Now);
        return Settle();
    }

    /// <summary>Writes the current frame to a PNG file.</summary>
    public void Screenshot(string path)
    {
        Settle();
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        using var file = File.Create(path);
        Platform.Frame!.Save(file, PngBitmapEncoderOptions.Default);
    }

    /// <summary>The color of a pixel, counted from the upper left corner of the window.</summary>
    public unsafe Color PixelAt(PixelPoint pixel)
    {
        Settle();
        using var frame = Platform.Frame!.Lock();
        var p = (byte*)frame.Address + (pixel.Y * frame.RowBytes) + (pixel.X * 4);
        return Color.FromArgb(p[3], p[2], p[1], p[0]);
    }

    /// <summary>Asks the window to close, as a window manager does.</summary>
    /// <returns>True if it stays open.</returns>
    public bool StaysOpen() => Platform.Closing?.Invoke(WindowCloseReason.WindowClosing) == true;

    /// <summary>The colors of all pixels, by column and row.</summary>
    public unsafe Color[,] Pixels()
    {
        Settle();
        using var frame = Platform.Frame!.Lock();
        var pixels = new Color[frame.Size.Width, frame.Size.Height];
        for (var y = 0; y < frame.Size.Height; y++)
        {
            for (var x = 0; x < frame.Size.Width; x++)
            {
                var p = (byte*)frame.Address + (y * frame.RowBytes) + (x * 4);
                pixels[x, y] = Color.FromArgb(p[3], p[2], p[1], p[0]);
            }
        }

        return pixels;
    }

    private ScreenUser WaitFor(Func<bool> condition, TimeSpan most, DispatcherPriority priority)
    {
        var watch = Stopwatch.StartNew();
        var frame = new DispatcherFrame();
        var isSo = false;
        ExceptionDispatchInfo? failure = null;
        var timer = new DispatcherTimer(TimeSpan.FromMilliseconds(16), priority, (_, _) =>
        {
            try
            {
                OffScreenClock.Current.Frame();
                isSo = condition();
            }
            catch (Exception e)
            {
                // Rethrown in the caller: after an exception from this timer, the next wait was observed never to end.
                failure = ExceptionDispatchInfo.Capture(e);
            }

            frame.Continue = failure is null && !isSo && watch.Elapsed < most;
        });
        timer.Start();
        Dispatcher.UIThread.PushFrame(frame);
        timer.Stop();
        failure?.Throw();
        return isSo ? Settle() : throw new TimeoutException($"What was waited for did not come within {most}.");
    }

    // A burst of keys as they were pressed, processed in one go.
    private void Queue(string text, ulong betweenMs)
    {
        ArgumentNullException.ThrowIfNull(text);
        var at = Now;
        foreach (var rune in text.EnumerateRunes())
        {
            Platform.Text(rune.ToString(), at += betweenMs);
        }

        Platform.Key(RawKeyEventType.KeyDown, Key.Enter, RawInputModifiers.None, at += betweenMs);
        Platform.Key(RawKeyEventType.KeyUp, Key.Enter, RawInputModifiers.None, at);
    }

    private static ulong Now => (ulong)Environment.TickCount64;

    private static Point Middle(Visual target) => new Rect(target.Bounds.Size).Center;

    private Point InWindow(Visual target, Point place) =>
        target.TranslatePoint(place, window) ?? throw new InvalidOperationException($"{target} is not in the window.");
}
