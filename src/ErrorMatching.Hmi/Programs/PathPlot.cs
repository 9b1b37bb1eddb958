using System.Collections;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws the path of a program; a tap selects a move and its block.</summary>
/// <remarks>Up to <see cref="MostShapes"/> visible strokes are drawn as shapes. More are drawn pixel by pixel into one bitmap, so
/// that the cost of a frame depends on the screen and not on the program.</remarks>
public sealed partial class PathPlot : PlotArea
{
    public static readonly StyledProperty<ProgramPicture?> PictureProperty = AvaloniaProperty.Register<PathPlot, ProgramPicture?>(
        nameof(Picture));

    public static readonly StyledProperty<IBrush?> ChosenBrushProperty = AvaloniaProperty.Register<PathPlot, IBrush?>(nameof(ChosenBrush));

    public static readonly StyledProperty<IBrush?> QuietBrushProperty = AvaloniaProperty.Register<PathPlot, IBrush?>(nameof(QuietBrush));

    public static readonly StyledProperty<IBrush?> OutlineBrushProperty = AvaloniaProperty.Register<PathPlot, IBrush?>(
        nameof(OutlineBrush));

    /// <summary>Maximum number of strokes drawn as shapes.</summary>
    public const int MostShapes = 1500;

    private readonly PathStrokes _strokes = new();
    private readonly PathPainter _painter;
    private BitArray? _featured;

    static PathPlot() => AffectsRender<PathPlot>(ChosenBrushProperty, QuietBrushProperty, OutlineBrushProperty);

    public PathPlot() => _painter = new(InvalidateVisual);

    public ProgramPicture? Picture
    {
        get => GetValue(PictureProperty);
        set => SetValue(PictureProperty, value);
    }

    /// <summary>Color of the selection.</summary>
    public IBrush? ChosenBrush
    {
        get => GetValue(ChosenBrushProperty);
        set => SetValue(ChosenBrushProperty, value);
    }

    /// <summary>Color of features other than the one that blocks are picked for.</summary>
    public IBrush? QuietBrush
    {
        get => GetValue(QuietBrushProperty);
        set => SetValue(QuietBrushProperty, value);
    }

    /// <summary>Color of an outline over the path.</summary>
    public IBrush? OutlineBrush
    {
        get => GetValue(OutlineBrushProperty);
        set => SetValue(OutlineBrushProperty, value);
    }

    /// <summary>True if the last frame was drawn pixel by pixel.</summary>
    internal bool IsByPixel { get; private set; }

    /// <summary>The current background painting, or the last one.</summary>
    public Task Painting => _painter.Painting;

    /// <inheritdoc/>
    protected override PlotBox Extent =>
        Picture is not { Program.Moves.Extent: var path }
            ? PlotBox.Empty
            : PlotBox.Of(Picture.Points.Select(p => p.At).Concat(Picture.Outline.SelectMany(l => l))) is var points && points.Touches(path)
            ? path.With(points)
            : path;

    /// <inheritdoc/>
    protected override int DatumCount => Picture?.Program.Moves.Count ?? 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == PictureProperty)
        {
            if (change.OldValue is ProgramPicture old)
            {
                old.PropertyChanged -= Follow;
            }

            if (change.NewValue is ProgramPicture picture && TopLevel.GetTopLevel(this) is not null)
            {
                picture.PropertyChanged += Follow;
            }

            Sort();
            Renew([]);
        }
    }

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        _painter.Begin();
        if (Picture is { } picture)
        {
            picture.PropertyChanged -= Follow;
            picture.PropertyChanged += Follow;

            // Changes made while the plot was not on the screen were not followed; read them now.
            Sort();
            Renew([]);
        }
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        if (Picture is { } picture)
        {
            picture.PropertyChanged -= Follow;
        }

        _painter.End();
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumNear(Point2 screen, double reach)
    {
        var place = View.ToPlot(screen);
        return Picture is { Program: var program } && program.Moves.Nearest(place, reach / View.ScaleX) is var motion and >= 0
            ? new(program.Moves.NearestOn(motion, place), program.TellMotion(motion), motion)
            : null;
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) =>
        Picture is { Program: var program } && program.Moves.EndsOf(index) is var (_, end)
            ? new(end, program.TellMotion(index), index)
            : null;

    /// <inheritdoc/>
    protected override bool IsDrawnIn(PlotBox box)
    {
        var (width, height) = ((box.Right - box.Left) * View.ScaleX, (box.High - box.Low) * View.ScaleY);
        var (room, view) = (new PlotBox(0, 0, width, height), View with { Middle = box.Middle, Width = width, Height = height });
        return Picture is { Program.Moves: var moves }
            && (
                Picture.Points.Any(p => box.Contains(p.At))
                    || !moves.Strokes(view, Pixel, s => room.PartOf(new(s.X1, s.Y1), new(s.X2, s.Y2)) is null));
    }

    /// <inheritdoc/>
    protected override bool IsAskedIn(PlotDatum datum, PlotBox box)
    {
        ArgumentNullException.ThrowIfNull(datum);
        return Picture is { Program.Moves: var moves }
            && moves.StrokesOf(datum.Index, View).Any(
                s => box.PartOf(View.ToPlot(new(s.X1, s.Y1)), View.ToPlot(new(s.X2, s.Y2))) is not null);
    }

    /// <inheritdoc/>
    protected override void OnAsked(PlotDatum datum)
    {
        ArgumentNullException.ThrowIfNull(datum);
        Picture!.LightMotion(datum.Index);
    }

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var program = Picture!.Program;
        IsByPixel = !_strokes.Take(program, view, Pixel);
        if (IsByPixel)
        {
            // The selection is drawn immediately and on top, unless it has too many strokes as well.
            var isLarge = !_strokes.TakeChosen(program, view, Picture.Selection);
            _painter.Show(
                context,
                new(
                    program,
                    view,
                    Pixel,
                    isLarge ? Picture.Selection : null,
                    _featured,
                    PixelLayer.ColorOf(Rule),
                    PixelLayer.ColorOf(Ink),
                    PixelLayer.ColorOf(ChosenBrush)));
        }

        foreach (var kind in Enum.GetValues<StrokeKind>())
        {
            _strokes.Draw(context, PenOf(kind), kind, Picture.Selection, _featured);
        }

        DrawOutline(context, view);
        DrawLabels(context, view, program);
        DrawEnds(context, view, program);
    }

    private void Follow(object? sender, System.ComponentModel.PropertyChangedEventArgs e)
    {
        switch (e.PropertyName)
        {
            case nameof(ProgramPicture.Selection):
                Light();
                break;
            case nameof(ProgramPicture.Marks):
                Sort();
                break;
            case nameof(ProgramPicture.Points) or nameof(ProgramPicture.Outline):
                Renew([]);
                break;
            case nameof(ProgramPicture.Feature):
                break;
            case nameof(ProgramPicture.Look):
                LookClosely(BoxOf(Picture!.Look!));
                break;
            default:
                return;
        }

        InvalidateVisual();
    }

    // Shows the selection, and hides the values of any other move.
    private void Light()
    {
        if (Picture is not { Selection: { } range, Program: var program, Cursor: var cursor })
        {
            return;
        }

        if (Asked is { } datum && !range.Contains(program.Path.Motions.BlockOf(datum.Index)))
        {
            Ask(null);
        }

        if (program.Path.MotionOf(cursor) is var motion and >= 0 && program.Moves.EndsOf(motion) is var (from, to))
        {
            Reveal(PlotBox.Empty.With(from).With(to));
        }
    }

    // The cuts with their key points.
    private PlotBox BoxOf(FeatureLook look)
    {
        var program = Picture!.Program;
        return program.MotionsOf(look.Blocks) is not var (first, last) ? PlotBox.Empty : Enumerable.Range(first, last - first + 1)
            .Where(m => look.Blocks.Contains(program.Path.Motions.BlockOf(m)))
            .Aggregate(
                PlotBox.Of(Picture.Points.Where(p => p.Feature == look.Feature).Select(p => p.At)),
                (box, m) => box.With(program.Moves.BoxOf(m)));
    }

    private void Sort()
    {
        _featured = Picture is { Marks.Count: > 0 } picture ? new BitArray(picture.Program.Count) : null;
        foreach (var range in Picture?.Marks.SelectMany(m => m.Ranges) ?? [])
        {
            for (var block = range.First; block <= range.Last; block++)
            {
                _featured![block] = true;
            }
        }
    }

    private Pen PenOf(StrokeKind kind) => kind switch
    {
        StrokeKind.Rapid => new Pen(Rule, DrawnSizes.Thin, DrawnSizes.RapidDashes),
        StrokeKind.Cut => new Pen(Ink, DrawnSizes.Cut, lineJoin: PenLineJoin.Bevel),
        StrokeKind.Feature => new Pen(Ink, DrawnSizes.Thick, lineJoin: PenLineJoin.Bevel),
        _ => new Pen(ChosenBrush, DrawnSizes.Thick, lineJoin: PenLineJoin.Bevel),
    };
}
