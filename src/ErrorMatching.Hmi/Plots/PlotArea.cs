using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A plot in its own units that can be zoomed (wheel, two fingers, buttons, plus and minus), panned (dragging, arrow
/// keys) and fitted. Tapping it shows exact values.</summary>
/// <remarks>Derived classes give the extent (<see cref="Extent"/>), draw what a <see cref="PlotView"/> shows (<see cref="Draw"/>)
/// and find the datum near a place (<see cref="DatumNear"/>). They call <see cref="Renew"/> when the data change. The data
/// themselves belong to view models. Keys: arrows pan, plus and minus zoom, 0 shows all, Space or Enter shows the values nearest
/// to the center, Page Up and Page Down go to the previous and next datum.</remarks>
[System.Diagnostics.CodeAnalysis.SuppressMessage(
    "Design", "CA1001", Justification = "The layer is let go when the plot leaves the screen.")]
public abstract partial class PlotArea : Control, IDrawnWords
{
    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Ink));

    public static readonly StyledProperty<IBrush?> RuleProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Rule));

    public static readonly StyledProperty<IBrush?> GroundProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Ground));

    public static readonly StyledProperty<double> LabelSizeProperty = AvaloniaProperty.Register<PlotArea, double>(nameof(LabelSize), 1);

    public static readonly StyledProperty<double> AroundProperty = AvaloniaProperty.Register<PlotArea, double>(nameof(Around));

    public static readonly StyledProperty<PlotArea?> TwinProperty = AvaloniaProperty.Register<PlotArea, PlotArea?>(nameof(Twin));

    public static readonly DirectProperty<PlotArea, string?> ValuesProperty = AvaloniaProperty.RegisterDirect<PlotArea, string?>(
        nameof(Values), p => p.Values);

    // Zoom out to a quarter of the fitted size at most. Zoom in no further than needed to see a micrometer of a meter.
    private const double LeastShare = 0.25, MostFactor = 1000;

    private static readonly Typeface Plain = new(FontFamily.Default),
        Strong = new(FontFamily.Default, FontStyle.Normal, FontWeight.SemiBold);

    private readonly StackPanel _buttons;
    private readonly HashSet<(string Words, Typeface Typeface)> _words = [];
    private PlotDatum? _datum;
    private PlotIndex _index = new([]);
    private PlotView _view;
    private PlotView _whole;

    static PlotArea()
    {
        AffectsRender<PlotArea>(InkProperty, RuleProperty, GroundProperty, LabelSizeProperty, BoundsProperty);
        FocusableProperty.OverrideDefaultValue<PlotArea>(true);
        ClipToBoundsProperty.OverrideDefaultValue<PlotArea>(true);
    }

    protected PlotArea()
    {
        _buttons = new StackPanel
        {
            Classes = { "near", "buttons" },
            HorizontalAlignment = HorizontalAlignment.Right,
            VerticalAlignment = VerticalAlignment.Top
        };
        _buttons.Children.AddRange(
            [
                MakeButton("Plot.Nearer", "plus", () => ZoomStep(1)),
                MakeButton("Plot.Further", "minus", () => ZoomStep(-1)),
                MakeButton("Plot.All", "all", ShowAllInBoth)]);
        LogicalChildren.Add(_buttons);
        VisualChildren.Add(_buttons);
    }

    /// <summary>Color of labels.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    /// <summary>Color of rules, frames and the crosshair.</summary>
    public IBrush? Rule
    {
        get => GetValue(RuleProperty);
        set => SetValue(RuleProperty, value);
    }

    /// <summary>Color of the background.</summary>
    public IBrush? Ground
    {
        get => GetValue(GroundProperty);
        set => SetValue(GroundProperty, value);
    }

    public double LabelSize
    {
        get => GetValue(LabelSizeProperty);
        set => SetValue(LabelSizeProperty, value);
    }

    /// <summary>Margin around the drawing when all is shown.</summary>
    public double Around
    {
        get => GetValue(AroundProperty);
        set => SetValue(AroundProperty, value);
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

    /// <summary>True if the whole extent is visible.</summary>
    public bool ShowsAll => _view == _whole;

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords =>
        [.. _words, .. KeptWords.Append(DatumCount > 0 ? DatumAt(0)?.Text : null).OfType<string>().Select(w => (w, Plain))];

    /// <summary>Words that are redrawn in later frames without being recreated.</summary>
    protected virtual IEnumerable<string> KeptWords => [];

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

    /// <summary>Number of data that Page Up and Page Down step through.</summary>
    protected virtual int DatumCount => 0;

    /// <summary>Shows the whole extent.</summary>
    public void ShowAll()
    {
        // Neither the buttons nor the side labels may hide part of it.
        var (left, top, right, bottom) = (Frame.Left, Frame.Top, Frame.Right + ButtonsRoom, Frame.Bottom);
        var fit = PlotView.Fit(
            Extent, Math.Max(Bounds.Width - left - right, 1), Math.Max(Bounds.Height - top - bottom, 1), Around, IsTrueToScale);
        _whole = (fit with { Width = Bounds.Width, Height = Bounds.Height }).Pan(new((left - right) / 2, (top - bottom) / 2));
        View = _whole;
    }

    /// <summary>Zooms; the place under a point of the screen stays there.</summary>
    public void Zoom(double factor, Point about)
    {
        var (least, most) = (LeastShare * _whole.ScaleX, MostFactor * _whole.ScaleX);
        View = Kept(View.Zoom(Math.Clamp(View.ScaleX * factor, least, most) / View.ScaleX, new(about.X, about.Y)));
        Lead();
    }

    /// <summary>Pans by a distance in screen units.</summary>
    public void Pan(Vector by)
    {
        View = Kept(View.Pan(new(by.X, by.Y)));
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
        DrawnPeer.Tell(this, old, Values);
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

        _words.Clear();
        Draw(context, View);
        ShowPixels(context);
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
            var fit = PlotView.Fit(box, Math.Max(Bounds.Width - ButtonsRoom, 1), Bounds.Height, Around, IsTrueToScale);
            View = (fit with { Width = Bounds.Width, Height = Bounds.Height }).Pan(new(-ButtonsRoom / 2, 0));
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

    /// <summary>Draws a label where room was found, with its leader line if it is away from its place.</summary>
    private protected void Words(DrawingContext context, FormattedText text, LabelRoom room)
    {
        if (room.Leader is var (from, to))
        {
            context.DrawLine(new Pen(Rule, DrawnSizes.Thin), from, to);
        }

        Words(context, text, room.Corner);
    }

    /// <summary>Draws text on its own background, so that lines do not cross it out.</summary>
    protected void Words(DrawingContext context, FormattedText text, Point at)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(text);
        if (Ground is ISolidColorBrush ground)
        {
            context.FillRectangle(
                new ImmutableSolidColorBrush(ground.Color, DrawnSizes.VeilOpacity),
                new Rect(at, new Size(text.Width, text.Height)).Inflate(new Thickness(DrawnSizes.VeilBeside, 0)),
                (float)DrawnSizes.VeilRound);
        }

        context.DrawText(text, at);
    }

    /// <summary>Text in the color of the plot's labels.</summary>
    protected FormattedText Label(string text, bool isStrong = false)
    {
        var typeface = isStrong ? Strong : Plain;
        _words.Add((text, typeface));
        return new(text, System.Globalization.CultureInfo.InvariantCulture, FlowDirection.LeftToRight, typeface, LabelSize, Ink);
    }

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
        ShowAll();
        Twin?.ShowAll();
    }

    // Keeps the drawing in sight: the center of the view stays within its box.
    private PlotView Kept(PlotView view) => Extent is { IsEmpty: false } extent
        ? view with
        {
            Middle = new(Math.Clamp(view.Middle.X, extent.Left, extent.Right), Math.Clamp(view.Middle.Y, extent.Low, extent.High))
        }
        : view;

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new DrawnPeer(this, AutomationControlType.Image, () => Values);

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        base.OnSizeChanged(e);
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
        foreach (var (button, part) in _buttons.Children.Zip(["nearer", "further", "all"]))
        {
            AutomationProperties.SetAutomationId(button, $"{AutomationProperties.GetAutomationId(this)}-{part}");
        }
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        _layer.LetGo();
    }
}
