using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>
/// A drawing in units of its own that is looked at closely: fit, nearer and further (wheel, two fingers, buttons, plus and minus), moved by dragging or by the arrows, with exact values under the finger.
/// </summary>
/// <remarks>
/// What derives from it says how much there is (<see cref="Extent"/>), draws what a <see cref="PlotView"/> shows of it (<see cref="Draw"/>), and what is near a place (<see cref="DatumNear"/>); it calls <see cref="Renew"/> when its data
/// are others. The data themselves belong to view models. Keys: arrows move, plus and minus zoom, 0 shows all, space or Enter asks for the values nearest to the middle, page up and down go to the datum before and behind.
/// </remarks>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "The layer is let go when the plot leaves the screen.")]
public abstract partial class PlotArea : Control, IDrawnWords
{
    /// <summary>Labels.</summary>
    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Ink));

    /// <summary>Rules, frames, and the crosshair.</summary>
    public static readonly StyledProperty<IBrush?> RuleProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Rule));

    /// <summary>What it is drawn on.</summary>
    public static readonly StyledProperty<IBrush?> GroundProperty = AvaloniaProperty.Register<PlotArea, IBrush?>(nameof(Ground));

    /// <summary>Size of the labels.</summary>
    public static readonly StyledProperty<double> LabelSizeProperty = AvaloniaProperty.Register<PlotArea, double>(nameof(LabelSize), 1);

    /// <summary>Room around what is drawn when all is shown.</summary>
    public static readonly StyledProperty<double> AroundProperty = AvaloniaProperty.Register<PlotArea, double>(nameof(Around));

    /// <summary>The plot beside it that shows the same place, as of before and after; null if there is none.</summary>
    public static readonly StyledProperty<PlotArea?> TwinProperty = AvaloniaProperty.Register<PlotArea, PlotArea?>(nameof(Twin));

    /// <summary>The exact values under the finger; null while none are asked for.</summary>
    public static readonly DirectProperty<PlotArea, string?> ValuesProperty = AvaloniaProperty.RegisterDirect<PlotArea, string?>(nameof(Values), p => p.Values);

    // Not further than to a quarter of all, and not nearer than a micrometer of a meter takes.
    private const double LeastShare = 0.25, MostFactor = 1000;

    private static readonly Typeface Plain = new(FontFamily.Default), Strong = new(FontFamily.Default, FontStyle.Normal, FontWeight.SemiBold);

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

    /// <summary>A plot with its buttons.</summary>
    protected PlotArea()
    {
        _buttons = new StackPanel { Classes = { "near", "buttons" }, HorizontalAlignment = HorizontalAlignment.Right, VerticalAlignment = VerticalAlignment.Top };
        _buttons.Children.AddRange([MakeButton("Plot.Nearer", "plus", () => ZoomStep(1)), MakeButton("Plot.Further", "minus", () => ZoomStep(-1)), MakeButton("Plot.All", "all", ShowAllInBoth)]);
        LogicalChildren.Add(_buttons);
        VisualChildren.Add(_buttons);
    }

    /// <summary>Labels.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    /// <summary>Rules, frames, and the crosshair.</summary>
    public IBrush? Rule
    {
        get => GetValue(RuleProperty);
        set => SetValue(RuleProperty, value);
    }

    /// <summary>What it is drawn on.</summary>
    public IBrush? Ground
    {
        get => GetValue(GroundProperty);
        set => SetValue(GroundProperty, value);
    }

    /// <summary>Size of the labels.</summary>
    public double LabelSize
    {
        get => GetValue(LabelSizeProperty);
        set => SetValue(LabelSizeProperty, value);
    }

    /// <summary>Room around what is drawn when all is shown.</summary>
    public double Around
    {
        get => GetValue(AroundProperty);
        set => SetValue(AroundProperty, value);
    }

    /// <summary>The plot beside it that shows the same place, as of before and after; null if there is none.</summary>
    public PlotArea? Twin
    {
        get => GetValue(TwinProperty);
        set => SetValue(TwinProperty, value);
    }

    /// <summary>The exact values under the finger; null while none are asked for.</summary>
    public string? Values => _datum?.Text;

    /// <summary>The datum that was asked for; null while none is.</summary>
    protected PlotDatum? Asked => _datum;

    /// <summary>What is seen.</summary>
    public PlotView View
    {
        get => _view;
        private set
        {
            if (_view != value)
            {
                _view = value;
                InvalidateVisual();

                // What is written here may depend on what has room there.
                Twin?.InvalidateVisual();
            }
        }
    }

    /// <summary>True while all is seen.</summary>
    public bool ShowsAll => _view == _whole;

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords => [.. _words, .. KeptWords.Append(DatumCount > 0 ? DatumAt(0)?.Text : null).OfType<string>().Select(w => (w, Plain))];

    /// <summary>Words that are drawn again from frame to frame without being made anew.</summary>
    protected virtual IEnumerable<string> KeptWords => [];

    /// <summary>How much there is to be seen; an empty box if there is nothing.</summary>
    protected abstract PlotBox Extent { get; }

    /// <summary>True if both directions have the same scale.</summary>
    protected virtual bool IsTrueToScale => true;

    /// <summary>Room at the sides that numbers and names take, where nothing is drawn.</summary>
    protected virtual Thickness Frame => default;

    /// <summary>Room at the right that the buttons take, with what is free around them.</summary>
    protected double ButtonsRoom => _buttons.DesiredSize.Width;

    /// <summary>Where a label may stand: not below the buttons.</summary>
    protected Rect Free => new(0, 0, Math.Max(0, Bounds.Width - ButtonsRoom), Bounds.Height);

    /// <summary>How many data there are that can be asked for one after the other.</summary>
    protected virtual int DatumCount => 0;

    /// <summary>Shows all there is.</summary>
    public void ShowAll()
    {
        // Neither the buttons nor what stands at the side hide anything of it.
        var (left, top, right, bottom) = (Frame.Left, Frame.Top, Frame.Right + ButtonsRoom, Frame.Bottom);
        var fit = PlotView.Fit(Extent, Math.Max(Bounds.Width - left - right, 1), Math.Max(Bounds.Height - top - bottom, 1), Around, IsTrueToScale);
        _whole = (fit with { Width = Bounds.Width, Height = Bounds.Height }).Pan(new((left - right) / 2, (top - bottom) / 2));
        View = _whole;
    }

    /// <summary>Nearer or further; the place under a point of the screen stays there.</summary>
    public void Zoom(double factor, Point about)
    {
        var (least, most) = (LeastShare * _whole.ScaleX, MostFactor * _whole.ScaleX);
        View = Kept(View.Zoom(Math.Clamp(View.ScaleX * factor, least, most) / View.ScaleX, new(about.X, about.Y)));
        Lead();
    }

    /// <summary>Moves what is seen, in units of the screen.</summary>
    public void Pan(Vector by)
    {
        View = Kept(View.Pan(new(by.X, by.Y)));
        Lead();
    }

    /// <summary>Shows the values of a datum with a crosshair, and moves there if it is not seen; null shows none.</summary>
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

    /// <summary>Draws what is seen.</summary>
    /// <param name="context">Where to draw, in units of the screen; it is cut off at the border.</param>
    /// <param name="view">Where what is.</param>
    protected abstract void Draw(DrawingContext context, PlotView view);

    /// <summary>What is nearest to a point of the screen; null if nothing is within reach.</summary>
    /// <param name="screen">Where the finger is.</param>
    /// <param name="reach">How far it may be, in units of the screen.</param>
    protected virtual PlotDatum? DatumNear(Point2 screen, double reach) => DatumAt(_index.Nearest(View.ToPlot(screen), View.ScaleX, View.ScaleY, reach));

    /// <summary>A datum by its number, from 0; null if there is none, as for -1.</summary>
    protected virtual PlotDatum? DatumAt(int index) => null;

    /// <summary>Called when a person has asked for a datum.</summary>
    protected virtual void OnAsked(PlotDatum datum)
    {
        // Who wants to know says so.
    }

    /// <summary>Moves what is seen to a box, if nothing of it is seen.</summary>
    protected void Reveal(PlotBox box)
    {
        if (!box.IsEmpty && !box.Touches(View.Seen))
        {
            View = View with { Middle = box.Middle };
        }
    }

    /// <summary>Shows all of a box and a little around it, beside the buttons.</summary>
    protected void LookClosely(PlotBox box)
    {
        if (!box.IsEmpty && Bounds is { Width: > 0, Height: > 0 })
        {
            var fit = PlotView.Fit(box, Math.Max(Bounds.Width - ButtonsRoom, 1), Bounds.Height, Around, IsTrueToScale);
            View = (fit with { Width = Bounds.Width, Height = Bounds.Height }).Pan(new(-ButtonsRoom / 2, 0));
            Lead();
        }
    }

    /// <summary>Says that the data are others. Whoever sees all goes on seeing all; whoever looks closely goes on looking there, as long as there is something.</summary>
    /// <param name="places">Where the data are, each at its number: they are found under a finger. None where <see cref="DatumNear"/> finds them in its own way.</param>
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

    /// <summary>True if a box lies over what was asked for.</summary>
    protected virtual bool IsAskedIn(PlotDatum datum, PlotBox box)
    {
        ArgumentNullException.ThrowIfNull(datum);
        return box.Contains(datum.At);
    }

    /// <summary>True if lines of the drawing lead through a box: what stands there hides them.</summary>
    protected virtual bool IsDrawnIn(PlotBox box) => false;

    /// <summary>Draws a label where it found room, with the line that leads to it where it stands away.</summary>
    private protected void Words(DrawingContext context, FormattedText text, LabelRoom room)
    {
        if (room.Leader is var (from, to))
        {
            context.DrawLine(new Pen(Rule, DrawnSizes.Thin), from, to);
        }

        Words(context, text, room.Corner);
    }

    /// <summary>Draws words on a ground of their own: a line behind them does not cross them out.</summary>
    protected void Words(DrawingContext context, FormattedText text, Point at)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(text);
        if (Ground is ISolidColorBrush ground)
        {
            context.FillRectangle(new ImmutableSolidColorBrush(ground.Color, DrawnSizes.VeilOpacity), new Rect(at, new Size(text.Width, text.Height)).Inflate(new Thickness(DrawnSizes.VeilBeside, 0)), (float)DrawnSizes.VeilRound);
        }

        context.DrawText(text, at);
    }

    /// <summary>A label in the plot's ink.</summary>
    protected FormattedText Label(string text, bool isStrong = false)
    {
        var typeface = isStrong ? Strong : Plain;
        _words.Add((text, typeface));
        return new(text, System.Globalization.CultureInfo.InvariantCulture, FlowDirection.LeftToRight, typeface, LabelSize, Ink);
    }

    // What is looked at closely here is looked at closely there.
    private void Lead()
    {
        if (Twin is { } twin)
        {
            twin.View = View with { Width = twin.Bounds.Width, Height = twin.Bounds.Height };
        }
    }

    // A person who wants to see all wants it in both.
    private void ShowAllInBoth()
    {
        ShowAll();
        Twin?.ShowAll();
    }

    // The drawing cannot be lost: its box holds the middle of the view.
    private PlotView Kept(PlotView view) => Extent is { IsEmpty: false } extent
        ? view with { Middle = new(Math.Clamp(view.Middle.X, extent.Left, extent.Right), Math.Clamp(view.Middle.Y, extent.Low, extent.High)) }
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
