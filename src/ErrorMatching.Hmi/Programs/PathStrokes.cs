using System.Collections;
using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>The visible strokes of a path that are drawn as shapes.</summary>
internal sealed class PathStrokes
{
    private readonly List<MoveStroke> _strokes = [];

    /// <summary>Each stroke as a line, in screen units.</summary>
    public IEnumerable<IReadOnlyList<Point>> Lines => _strokes.Select(s => (IReadOnlyList<Point>)[new(s.X1, s.Y1), new(s.X2, s.Y2)]);

    private bool HasRoom => _strokes.Count < PathPlot.MostShapes;

    /// <summary>Collects all visible strokes; keeps none if they are too many.</summary>
    /// <returns>True if they are kept.</returns>
    public bool Take(OpenedProgram program, PlotView view, double pixel)
    {
        _strokes.Clear();
        var isAll = program.Moves.Strokes(
            view,
            pixel,
            stroke =>
            {
                _strokes.Add(stroke);
                return HasRoom;
            });
        if (!isAll)
        {
            _strokes.Clear();
        }

        return isAll;
    }

    /// <summary>Collects the strokes of the selected blocks; keeps none if they are too many.</summary>
    /// <returns>True if they are kept.</returns>
    public bool TakeChosen(OpenedProgram program, PlotView view, BlockRange? selection)
    {
        _strokes.Clear();
        if (selection is not { } range || program.MotionsOf(range) is not var (first, last))
        {
            return true;
        }

        for (var i = first; i <= last && last - first < PathPlot.MostShapes && HasRoom; i++)
        {
            _strokes.AddRange(range.Contains(program.Path.Motions.BlockOf(i)) ? program.Moves.StrokesOf(i, view) : []);
        }

        var isAll = last - first < PathPlot.MostShapes && HasRoom;
        if (!isAll)
        {
            _strokes.Clear();
        }

        return isAll;
    }

    /// <summary>Draws the strokes of a kind as one shape.</summary>
    /// <param name="context">Where to draw.</param>
    /// <param name="pen">The pen for this kind.</param>
    /// <param name="kind">The kind.</param>
    /// <param name="chosen">The selected blocks; null if none are.</param>
    /// <param name="featured">The blocks that belong to features; null if none do.</param>
    public void Draw(DrawingContext context, Pen pen, StrokeKind kind, BlockRange? chosen, BitArray? featured)
    {
        var geometry = new StreamGeometry();
        var end = default(Point?);
        using (var figure = geometry.Open())
        {
            foreach (var stroke in _strokes.Where(s => PathFrame.KindOf(s, chosen, featured) == kind))
            {
                if (end != new Point(stroke.X1, stroke.Y1))
                {
                    if (end is not null)
                    {
                        figure.EndFigure(isClosed: false);
                    }

                    figure.BeginFigure(new(stroke.X1, stroke.Y1), isFilled: false);
                }

                figure.LineTo(new(stroke.X2, stroke.Y2));
                end = new(stroke.X2, stroke.Y2);
            }

            if (end is not null)
            {
                figure.EndFigure(isClosed: false);
            }
        }

        if (end is not null)
        {
            context.DrawGeometry(null, pen, geometry);
        }
    }
}

/// <summary>A straight piece of a path, in screen units.</summary>
/// <param name="X1">Start, x.</param>
/// <param name="Y1">Start, y.</param>
/// <param name="X2">End, x.</param>
/// <param name="Y2">End, y.</param>
/// <param name="Block">Its block.</param>
/// <param name="IsRapid">True for a rapid move, which cuts nothing.</param>
public readonly record struct MoveStroke(float X1, float Y1, float X2, float Y2, int Block, bool IsRapid);

/// <summary>How a stroke is drawn, from the bottom layer to the top.</summary>
internal enum StrokeKind
{
    /// <summary>Dashed: a rapid.</summary>
    Rapid,

    /// <summary>Solid: a cut.</summary>
    Cut,

    /// <summary>Thick: part of a feature.</summary>
    Feature,

    /// <summary>Thick and in the selection's color, with a ring at its start and a dot at its end.</summary>
    Chosen,
}
