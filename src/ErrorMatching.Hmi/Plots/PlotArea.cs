using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A plot in its own units that can be zoomed (wheel, two fingers, buttons, plus and minus), panned (dragging, arrow
/// keys) and fitted. Tapping it shows exact values.</summary>
/// <remarks>Derived classes give the extent (<see cref="Extent"/>), draw what a <see cref="PlotView"/> shows (<see cref="Draw"/>)
/// and find the datum near a place (<see cref="DatumNear"/>). They call <see cref="Renew"/> when the data change. The data
/// themselves belong to view models. Keys: arrows pan, plus and minus zoom, 0 shows all, Escape leaves a plot that fills the screen,
/// Space or Enter shows the values nearest to the center, Page Up and Page Down go to the previous and next datum.</remarks>
public abstract class PlotArea : PlotPaper, IDrawnWords
{
    public static readonly StyledProperty<double> AroundProperty = AvaloniaProperty.Register<PlotArea, double>(nameof(Around));

    public static readonly StyledProperty<string?> CaptionProperty = AvaloniaProperty.Register<PlotArea, string?>(nameof(Caption));

    public static readonly StyledProperty<PlotArea?> TwinProperty = AvaloniaProperty.Register<PlotArea, PlotArea?>(nameof(Twin));

    public static readonly DirectProperty<PlotArea, string?> ValuesProperty = AvaloniaProperty.RegisterDirect<PlotArea, string?>(
        nameof(Values), p => p.Values);

    // Zoom out to a quarter of the fitted size at most. Zoom in no further than needed to see a micrometer of a meter.
    private const double LeastShare = 0.25, MostFactor = 1000;

    private const double StepFactor = 1.5, WheelFactor = 1.25, KeyShare = 0.125;

    private readonly UniformGrid _buttons;
    private readonly PlotFingers _fingers;
    private PlotDatum? _datum;
    private PlotEnlarging? _enlarging;
    private PlotIndex _index = new([]);
    private PlotView _view;
    private PlotView _whole;

    static PlotArea()
    {
        AffectsRender<PlotArea>(BoundsProperty, CaptionProperty);
        FocusableProperty.OverrideDefaultValue<PlotArea>(true);
        ClipToBoundsProperty.OverrideDefaultValue<PlotArea>(true);
    }

    protected PlotArea()
    {
        _fingers = new(this);
        _buttons = PlotButtons.Of(() => ZoomStep(1), () => ZoomStep(-1), ShowAllInBoth, FillOrLeave);
        LogicalChildren.Add(_buttons);
        VisualChildren.Add(_buttons);
    }

    /// <summary>Margin around the drawing when all is shown.</summary>
    public double Around
    {
        get => GetValue(AroundProperty);
        set => SetValue(AroundProperty, value);
    }

    /// <summary>What is said above the drawing, in room of its own; null for nothing.</summary>
    public string? Caption
    {
        get => GetValue(CaptionProperty);
        set => SetValue(CaptionProperty, value);
    }

    /// <summary>The plot next to this one that shows the same place, for example before and after; null if there is none.</summary>
    public PlotArea? Twin
    {
        get => GetValue(TwinProperty);
        set => SetValue(TwinProperty, value);
    }

    /// <summary>The exact values of the selected datum; null if none is selected.</summary>
    public string? Values => _datum?.Text;

    /// <summary>The selected datum; null if none is selected.</summary>
    protected PlotDatum? Asked => _datum;

    /// <summary>The visible part.</summary>
    public PlotView View
    {
        get => _view;
        private set
        {
            if (_view != value)
            {
                _view = value;
                InvalidateVisual();

                // The twin's labels may depend on the room here.
                Twin?.InvalidateVisual();
            }
        }
    }

    /// <summary>Where the values were last shown, in screen units.</summary>
    internal Rect ValuesRoom { get; private set; }

    /// <summary>True if the whole extent is visible.</summary>
    public bool ShowsAll => _view == _whole;

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords =>
        [.. WordsDrawn, .. StoredWords.Append(DatumCount > 0 ? DatumAt(0)?.Text : null).OfType<string>().Select(w => (w, Plain))];

    /// <summary>Words that are redrawn in later frames without being recreated.</summary>
    protected virtual IEnumerable<string> StoredWords => [];

    /// <summary>Extent of the data; an empty box if there are none.</summary>
    protected abstract PlotBox Extent { get; }

    /// <summary>True if both directions have the same scale.</summary>
    protected virtual bool IsTrueToScale => true;

    /// <summary>Margins for numbers and names, where nothing else is drawn.</summary>
    protected virtual Thickness Frame => default;

    /// <summary>Width at the right that the buttons need, including their margins.</summary>
    protected double ButtonsRoom => _buttons.DesiredSize.Width;

    /// <summary>Where labels may be placed: not below the buttons.</summary>
    protected Rect Free => new(0, 0, Math.Max(0, Bounds.Width - ButtonsRoom), Bounds.Height);

    /// <summary>True if it fills the screen that it is on.</summary>
    public bool FillsScreen => _enlarging is not null;

    /// <summary>Number of data that Page Up and Page Down step through.</summary>
    protected virtual int DatumCount => 0;

    /// <summary>Shows the whole extent.</summary>
    public void ShowAll()
    {
        // Neither the buttons nor the side labels nor the caption may hide part of it.
        var above = CaptionText() is { } caption ? caption.Height + (2 * DrawnSizes.Around) : 0;
        _whole = Fitted(Extent, new(Frame.Left, Frame.Top + above, Frame.Right + ButtonsRoom, Frame.Bottom));
        View = _whole;
    }

    /// <summary>Zooms; the place under a point of the screen stays there.</summary>
    public void Zoom(double factor, Point about)
    {
        var (least, most) = (LeastShare * _whole.ScaleX, MostFactor * _whole.ScaleX);
        View = Stored(View.Zoom(Math.Clamp(View.ScaleX * factor, least, most) / View.ScaleX, new(about.X, about.Y)));
        Lead();
    }

    /// <summary>Pans by a distance in screen units.</summary>
    public virtual void Pan(Vector by)
    {
        View = Stored(View.Pan(new(by.X, by.Y)));
        Lead();
    }

    /// <summary>Shows the values of a datum with a crosshair, and pans to it if it is not visible; null hides them.</summary>
    public void Ask(PlotDatum? datum)
    {
        var old = Values;
        _datum = datum;
        if (datum is not null && !View.Seen.Contains(datum.At))
        {
            View = View with { Middle = datum.At };
        }

        RaisePropertyChanged(ValuesProperty, old, Values);
        DrawnPeer.Report(this, old, Values);
        AutomationProperties.SetHelpText(this, Values ?? "");
        InvalidateVisual();
    }

    /// <inheritdoc/>
    public sealed override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (Ground is { } ground)
        {
            context.FillRectangle(ground, new Rect(Bounds.Size));
        }

        if (Extent.IsEmpty || Bounds.Width < 1 || Bounds.Height < 1)
        {
            return;
        }

        Begin();
        Draw(context, View);
        ShowPixels(context);
        if (CaptionText() is { } caption)
        {
            Words(context, caption, new Point(DrawnSizes.Around, DrawnSizes.Around));
        }

        if (_datum is { } datum)
        {
            Crosshair(context, datum);
        }
    }

    /// <summary>Draws the visible part.</summary>
    /// <param name="context">Where to draw, in screen units; clipped to the border.</param>
    /// <param name="view">The visible part.</param>
    protected abstract void Draw(DrawingContext context, PlotView view);

    /// <summary>The datum nearest to a point of the screen; null if none is within reach.</summary>
    /// <param name="screen">The point.</param>
    /// <param name="reach">Largest distance, in screen units.</param>
    protected virtual PlotDatum? DatumNear(Point2 screen, double reach) =>
        DatumAt(_index.Nearest(View.ToPlot(screen), View.ScaleX, View.ScaleY, reach));

    /// <summary>A datum by its index, from 0; null if there is none, as for -1.</summary>
    protected virtual PlotDatum? DatumAt(int index) => null;

    /// <summary>Called when the user has selected a datum.</summary>
    protected virtual void OnAsked(PlotDatum datum)
    {
    }

    /// <summary>Pans to a box if no part of it is visible.</summary>
    protected void Reveal(PlotBox box)
    {
        if (!box.IsEmpty && !box.Touches(View.Seen))
        {
            View = View with { Middle = box.Middle };
        }
    }

    /// <summary>Zooms to a box with a small margin, left of the buttons.</summary>
    protected void LookClosely(PlotBox box)
    {
        if (!box.IsEmpty && Bounds is { Width: > 0, Height: > 0 })
        {
            View = Fitted(box, new(0, 0, ButtonsRoom, 0));
            Lead();
        }
    }

    /// <summary>Call this when the data have changed. A view of everything still shows everything; a closer view stays where it
    /// is as long as it still shows data.</summary>
    /// <param name="places">Positions of the data, by index, to find the datum under a finger. Empty if <see cref="DatumNear"/>
    /// is overridden.</param>
    protected void Renew(IReadOnlyList<Point2> places)
    {
        _index = new(places);
        ForgetPixels();
        var (isWhole, view) = (ShowsAll, View);
        Ask(null);
        ShowAll();
        if (!isWhole && Extent.Touches(view.Seen))
        {
            View = view;
        }

        InvalidateVisual();
    }

    /// <summary>True if a box would hide the selected datum.</summary>
    protected virtual bool IsAskedIn(PlotDatum datum, PlotBox box)
    {
        ArgumentNullException.ThrowIfNull(datum);
        return box.Contains(datum.At);
    }

    /// <summary>True if a line of the drawing crosses a box: text there would hide it.</summary>
    protected virtual bool IsDrawnIn(PlotBox box) => false;

    /// <summary>Shows everything, as when the plot was opened.</summary>
    protected virtual void Reset() => ShowAll();

    /// <summary>What an arrow key does: by default, it pans against its direction, so that the eye goes where it points.</summary>
    protected virtual void Step(Vector by) => Pan(by);

    // The twin follows this plot.
    private void Lead()
    {
        if (Twin is { } twin)
        {
            twin.View = View with { Width = twin.Bounds.Width, Height = twin.Bounds.Height };
        }
    }

    // Show all applies to both plots.
    private void ShowAllInBoth()
    {
        Reset();
        Twin?.Reset();
    }

    private FormattedText? CaptionText()
    {
        if (string.IsNullOrEmpty(Caption))
        {
            return null;
        }

        var text = Label(Caption);
        text.MaxTextWidth = Math.Max(1, Free.Width - (2 * DrawnSizes.Around));
        return text;
    }

    private void FillOrLeave()
    {
        if (FillsScreen)
        {
            Leave();
        }
        else
        {
            _enlarging = new(this);
        }
    }

    private void Leave()
    {
        _enlarging?.Leave();
        _enlarging = null;
    }

    private PlotView Fitted(PlotBox box, Thickness frame)
    {
        var (width, height) = (Bounds.Width - frame.Left - frame.Right, Bounds.Height - frame.Top - frame.Bottom);
        var fit = PlotView.Fit(box, Math.Max(width, 1), Math.Max(height, 1), Around, IsTrueToScale);
        return (fit with { Width = Bounds.Width, Height = Bounds.Height }).Pan(
            new((frame.Left - frame.Right) / 2, (frame.Top - frame.Bottom) / 2));
    }

    // Keeps the drawing in sight: the center of the view stays within its box.
    private PlotView Stored(PlotView view) => Extent is { IsEmpty: false } extent
        ? view with
        {
            Middle = new(Math.Clamp(view.Middle.X, extent.Left, extent.Right), Math.Clamp(view.Middle.Y, extent.Low, extent.High))
        }
        : view;

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new DrawnPeer(this, AutomationControlType.Image, () => Values);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == CaptionProperty)
        {
            ShowAll();
        }
    }

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        base.OnSizeChanged(e);
        PlotButtons.Lay(_buttons, Bounds.Size);
        var (isWhole, view) = (ShowsAll, View);
        ShowAll();
        if (!isWhole)
        {
            View = view with { Width = Bounds.Width, Height = Bounds.Height };
        }
    }

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        PlotButtons.Name(_buttons, AutomationProperties.GetAutomationId(this));
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        Leave();
    }

    /// <inheritdoc/>
    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        Focus();
        _fingers.Press(e);
    }

    /// <inheritdoc/>
    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        _fingers.Move(e);
    }

    /// <inheritdoc/>
    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        if (_fingers.Release(e))
        {
            var at = e.GetPosition(this);
            AskFor(DatumNear(new(at.X, at.Y), DrawnSizes.FingerReach));
        }
    }

    /// <inheritdoc/>
    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerCaptureLost(e);
        _fingers.Lose(e);
    }

    /// <inheritdoc/>
    protected override void OnPointerWheelChanged(PointerWheelEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerWheelChanged(e);
        Zoom(Elementary.Pow(WheelFactor, e.Delta.Y), e.GetPosition(this));
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
        Action? act = key switch
        {
            Key.Left => () => Step(new(x, 0)),
            Key.Right => () => Step(new(-x, 0)),
            Key.Up => () => Step(new(0, y)),
            Key.Down => () => Step(new(0, -y)),
            Key.Add or Key.OemPlus => () => ZoomStep(1),
            Key.Subtract or Key.OemMinus => () => ZoomStep(-1),
            Key.D0 or Key.NumPad0 => ShowAllInBoth,
            Key.Space or Key.Enter => () => AskFor(DatumNear(new(Bounds.Width / 2, Bounds.Height / 2), double.PositiveInfinity)),
            Key.Escape when FillsScreen => Leave,
            Key.PageDown when DatumCount > 0 => () => AskForNext(-1, 1),
            Key.PageUp when DatumCount > 0 => () => AskForNext(DatumCount, -1),
            _ => null,
        };
        act?.Invoke();
        return act is not null;
    }

    private void AskForNext(int before, int step) => AskFor(DatumAt(Math.Clamp((_datum?.Index ?? before) + step, 0, DatumCount - 1)));

    private void AskFor(PlotDatum? datum)
    {
        Ask(datum);
        if (datum is not null)
        {
            OnAsked(datum);
        }
    }

    private void ZoomStep(int steps) => Zoom(Elementary.Pow(StepFactor, steps), new Point(Bounds.Width / 2, Bounds.Height / 2));

    // Crosshair lines across the whole plot, and a box with the values next to the datum if there is room.
    private void Crosshair(DrawingContext context, PlotDatum datum)
    {
        var at = View.At(datum.At);
        var pen = new Pen(Rule, DrawnSizes.Thin);
        context.DrawLine(pen, new Point(at.X, 0), new Point(at.X, Bounds.Height));
        context.DrawLine(pen, new Point(0, at.Y), new Point(Bounds.Width, at.Y));
        context.DrawEllipse(null, new Pen(Ink, DrawnSizes.Line), at, DrawnSizes.Ring, DrawnSizes.Ring);

        // In a narrow plot, values below each other hide less.
        FormattedText[] texts = [Label(datum.Text), Label(datum.Text.Replace("  ", "\n", StringComparison.Ordinal))];
        var free = new Size(Bounds.Width - ButtonsRoom, Bounds.Height);
        var (text, box) = new ValuesBox(free, at, b => IsDrawnIn(BoxOf(b)), b => IsAskedIn(datum, BoxOf(b))).Place(texts);
        ValuesRoom = box;
        context.DrawRectangle(Ground, new Pen(Ink, DrawnSizes.Thin), box);
        context.DrawText(text, box.TopLeft + new Point(DrawnSizes.Around, DrawnSizes.Around));
    }

    private PlotBox BoxOf(Rect room)
    {
        var (from, to) = (View.ToPlot(new(room.Left, room.Bottom)), View.ToPlot(new(room.Right, room.Top)));
        return new(from.X, from.Y, to.X, to.Y);
    }
}
