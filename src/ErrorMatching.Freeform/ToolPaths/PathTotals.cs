using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The totals of a path: number of points, length, and the largest errors with their places.</summary>
/// <param name="context">What the path is planned with.</param>
internal sealed class PathTotals(PlanningContext context)
{
    /// <summary>Most points of a path: beyond it a tolerance or a unit is wrong.</summary>
    public const int MostPoints = 50_000_000;

    private (double Mm, Point2 At) _chord;
    private (double Mm, Point2 At) _scallop = (double.NegativeInfinity, default);
    private (double Mm, Point2 At) _raised;
    private int _raisedPoints;

    public int Points { get; private set; }

    public double LengthMm { get; private set; }

    /// <summary>The measurements of the path.</summary>
    // If chords cut in by more than the height of the ridge, nothing is left over the surface. The height is then 0, not negative.
    public ToolPathCertificate Certificate => new(
        _chord.Mm,
        context.PlaceOf(_chord.At),
        Math.Max(0, _scallop.Mm),
        context.PlaceOf(_scallop.At),
        context.GougeMm,
        _raisedPoints,
        _raised.Mm,
        context.PlaceOf(_raised.At));

    /// <summary>The refusal of a path with too many points.</summary>
    public static Refusal TooLong(string points) =>
        new(
            "path-too-long",
            string.Create(
                CultureInfo.InvariantCulture,
                $"the path would have {points} points; at most {MostPoints} are made. Check the units of the surface, and scallopMm and "
                    + $"chordMm."));

    /// <summary>Adds a piece.</summary>
    public void Count(CenterLine line)
    {
        Points += line.Count;
        if (Points > MostPoints)
        {
            context.Refusal ??= TooLong("more");
        }

        var (chord, at) = line.Chord;
        _chord = chord > _chord.Mm ? (chord, at) : _chord;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Raised[i] > 0)
            {
                _raisedPoints++;
                _raised = line.Raised[i] > _raised.Mm ? (line.Raised[i], line.Places[i]) : _raised;
            }

            LengthMm += i > 0 ? (line.Centers[i] - line.Centers[i - 1]).Length : 0;
        }
    }

    /// <summary>Adds the height of a ridge between two passes.</summary>
    public void Count(double heightMm, Point2 at) => _scallop = heightMm > _scallop.Mm ? (heightMm, at) : _scallop;

    /// <summary>Adds the totals of a part of the path.</summary>
    public void Merge(PathTotals part)
    {
        Points += part.Points;
        LengthMm += part.LengthMm;
        _raisedPoints += part._raisedPoints;
        _chord = part._chord.Mm > _chord.Mm ? part._chord : _chord;
        _scallop = part._scallop.Mm > _scallop.Mm ? part._scallop : _scallop;
        _raised = part._raised.Mm > _raised.Mm ? part._raised : _raised;
    }
}
