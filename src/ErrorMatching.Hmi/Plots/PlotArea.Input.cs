using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.Markup.Xaml.MarkupExtensions;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <content>Touch, pointer, wheel and keyboard input.</content>
public abstract partial class PlotArea
{
    private const double StepFactor = 1.5, WheelFactor = 1.25, KeyShare = 0.125;

    private readonly Dictionary<int, Point> _fingers = [];
    private Point _pressed;
    private bool _hasMoved;

    /// <summary>Where the values were last shown, in screen units.</summary>
    internal Rect ValuesRoom { get; private set; }

    /// <inheritdoc/>
    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        Focus();
        var at = e.GetPosition(this);
        if (_fingers.Count == 0)
        {
            (_pressed, _hasMoved) = (at, false);
        }

        _fingers[e.Pointer.Id] = at;
        e.Pointer.Capture(this);
        e.PreventGestureRecognition();
        e.Handled = true;
    }

    /// <inheritdoc/>
    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        if (!_fingers.TryGetValue(e.Pointer.Id, out var before))
        {
            return;
        }

        var at = e.GetPosition(this);
        if (_fingers.Count > 1)
        {
            // Two fingers: the places under both stay under them, as far as a single scale allows.
            var other = _fingers.First(f => f.Key != e.Pointer.Id).Value;
            _hasMoved = true;
            var (was, now) = (Point.Distance(before, other), Point.Distance(at, other));
            Pan((at - before) / 2);
            if (was > DrawnSizes.FingerStill && now > DrawnSizes.FingerStill)
            {
                Zoom(now / was, (at + other) / 2);
            }
        }
        else if (_hasMoved || Point.Distance(at, _pressed) > DrawnSizes.FingerStill)
        {
            Pan(at - (_hasMoved ? before : _pressed));
            _hasMoved = true;
        }

        _fingers[e.Pointer.Id] = at;
        e.Handled = true;
    }

    /// <inheritdoc/>
    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        if (_fingers.Remove(e.Pointer.Id) && _fingers.Count == 0 && !_hasMoved)
        {
            var at = e.GetPosition(this);
            AskFor(DatumNear(new(at.X, at.Y), DrawnSizes.FingerReach));
        }

        e.Handled = true;
    }

    /// <inheritdoc/>
    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerCaptureLost(e);
        _fingers.Remove(e.Pointer.Id);
    }

    /// <inheritdoc/>
    protected override void OnPointerWheelChanged(PointerWheelEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerWheelChanged(e);
        Zoom(Math.Pow(WheelFactor, e.Delta.Y), e.GetPosition(this));
        e.Handled = true;
    }

    /// <inheritdoc/>
    protected override void OnKeyDown(KeyEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnKeyDown(e);
        e.Handled = e.KeyModifiers == KeyModifiers.None || e.KeyModifiers == KeyModifiers.Shift ? Do(e.Key) : e.Handled;
    }

    private bool Do(Key key)
    {
        var (x, y) = (KeyShare * Bounds.Width, KeyShare * Bounds.Height);
        switch (key)
        {
            case Key.Left:
                Pan(new(x, 0));
                return true;
            case Key.Right:
                Pan(new(-x, 0));
                return true;
            case Key.Up:
                Pan(new(0, y));
                return true;
            case Key.Down:
                Pan(new(0, -y));
                return true;
            case Key.Add or Key.OemPlus:
                ZoomStep(1);
                return true;
            case Key.Subtract or Key.OemMinus:
                ZoomStep(-1);
                return true;
            case Key.D0 or Key.NumPad0:
                ShowAllInBoth();
                return true;
            case Key.Space or Key.Enter:
                AskFor(DatumNear(new(Bounds.Width / 2, Bounds.Height / 2), double.PositiveInfinity));
                return true;
            case Key.PageDown or Key.PageUp when DatumCount > 0:
                var next = (_datum?.Index ?? (key == Key.PageDown ? -1 : DatumCount)) + (key == Key.PageDown ? 1 : -1);
                AskFor(DatumAt(Math.Clamp(next, 0, DatumCount - 1)));
                return true;
            default:
                return false;
        }
    }

    private void AskFor(PlotDatum? datum)
    {
        Ask(datum);
        if (datum is not null)
        {
            OnAsked(datum);
        }
    }

    private void ZoomStep(int steps) => Zoom(Math.Pow(StepFactor, steps), new Point(Bounds.Width / 2, Bounds.Height / 2));

    private static Button MakeButton(string text, string icon, Action act)
    {
        var button = new Button
        {
            Classes = { "plot" },
            Content = new Avalonia.Controls.Shapes.Path
            {
                Classes = { "icon" },
                [!Avalonia.Controls.Shapes.Path.DataProperty] = new DynamicResourceExtension("Icon." + icon)
            },
            [!AutomationProperties.NameProperty] = new ReflectionBinding($"[{text}]") { Source = Texts.Current, Mode = BindingMode.OneWay },
        };
        button.Click += (_, _) => act();
        return button;
    }

    // Crosshair lines across the whole plot, and a box with the values next to the datum if there is room.
    private void Crosshair(DrawingContext context, PlotDatum datum)
    {
        var at = View.ToScreen(datum.At);
        var (x, y) = (at.X, at.Y);
        var pen = new Pen(Rule, DrawnSizes.Thin);
        context.DrawLine(pen, new Point(x, 0), new Point(x, Bounds.Height));
        context.DrawLine(pen, new Point(0, y), new Point(Bounds.Width, y));
        context.DrawEllipse(null, new Pen(Ink, DrawnSizes.Line), new Point(x, y), DrawnSizes.Ring, DrawnSizes.Ring);

        // In a narrow plot, values below each other hide less.
        FormattedText[] texts = [Label(datum.Text), Label(datum.Text.Replace("  ", "\n", StringComparison.Ordinal))];
        var fitting = texts.Where(t => SizeOf(t).Width <= Bounds.Width - ButtonsRoom).ToArray();
        var rooms = fitting.Select(t => (Text: t, Box: FreeRoom(SizeOf(t), new(x, y))))
            .Concat(fitting.Select(t => (Text: t, Box: Corner(SizeOf(t), datum))))
            .Append((Text: texts[1], Box: FarCorner(SizeOf(texts[1]), new(x, y))));
        var (text, box) = rooms.Where(r => r.Box is not null).Select(r => (r.Text, r.Box!.Value)).First();
        ValuesRoom = box;
        context.DrawRectangle(Ground, new Pen(Ink, DrawnSizes.Thin), box);
        context.DrawText(text, box.TopLeft + new Point(DrawnSizes.Around, DrawnSizes.Around));
    }

    private static Size SizeOf(FormattedText text) => new(text.Width + (2 * DrawnSizes.Around), text.Height + (2 * DrawnSizes.Around));

    // A position next to the datum, nearest first, or else in a corner, where the box hides no line.
    private Rect? FreeRoom(Size size, Point at)
    {
        var (right, low) = RoomsEnd(size);
        var beside = DrawnSizes.BoxAway.SelectMany(a => new[] { (1, -1), (-1, -1), (1, 1), (-1, 1) }.Select(s => new Point(
            s.Item1 > 0 ? at.X + a : at.X - a - size.Width,
            s.Item2 > 0 ? at.Y + a : at.Y - a - size.Height))).Where(p => p.X >= 0 && p.X <= right && p.Y >= 0 && p.Y <= low);
        var places = beside.Concat(Corners(size)).Select(p => new Rect(p, size)).ToArray();
        return Array.Find(places, p => !p.Contains(at) && !IsDrawnIn(BoxOf(p))) is { Width: > 0 } free ? free : null;
    }

    // If there is no such position: the farthest corner that does not hide the marked item.
    private Rect? Corner(Size size, PlotDatum datum) =>
        Corners(size).Select(c => new Rect(c, size))
            .Where(c => !IsAskedIn(datum, BoxOf(c)))
            .OrderByDescending(c => Point.Distance(c.Center, View.At(datum.At)))
            .Select(c => (Rect?)c)
            .FirstOrDefault();

    private Rect FarCorner(Size size, Point at) => Corners(size).Select(c => new Rect(c, size)).MaxBy(c => Point.Distance(c.Center, at));

    private Point[] Corners(Size size) =>
        RoomsEnd(size) is var (right, low) ? [new(0, 0), new(0, low), new(right, low), new(right, 0)] : [];

    private (double Right, double Low) RoomsEnd(Size size) =>
        (Math.Max(0, Bounds.Width - ButtonsRoom - size.Width), Math.Max(0, Bounds.Height - size.Height));

    private PlotBox BoxOf(Rect room)
    {
        var (from, to) = (View.ToPlot(new(room.Left, room.Bottom)), View.ToPlot(new(room.Right, room.Top)));
        return new(from.X, from.Y, to.X, to.Y);
    }
}
