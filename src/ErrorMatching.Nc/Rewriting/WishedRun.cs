using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Cutting motions that follow one another, measured by length, with the displacements wished at places along them.</summary>
internal sealed class WishedRun
{
    private readonly NcPath path;
    private readonly int first;
    private readonly double[] starts;
    private readonly List<(double Along, int Motion, double Fraction, DisplacedPoint Point)> feet = [];

    /// <summary>A run.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="first">Its first motion.</param>
    /// <param name="last">Its last motion.</param>
    public WishedRun(NcPath path, int first, int last)
    {
        (this.path, this.first) = (path, first);
        starts = new double[last - first + 2];
        for (var i = 1; i < starts.Length; i++)
        {
            starts[i] = starts[i - 1] + path.Motions[first + i - 1].PlaneLength;
        }
    }

    /// <summary>How far a place is from the run, and from which of its motions.</summary>
    public (double DistanceMm, int Motion) NearestTo(Point2 place) => Foot(place) is var foot ? (foot.DistanceMm, foot.Motion) : default;

    /// <summary>Takes the points that lie on the run.</summary>
    /// <returns>A refusal where there are none, or where two of them disagree.</returns>
    public NcRefusal? Take(IReadOnlyList<DisplacedPoint> points, double furthestMm)
    {
        foreach (var point in points)
        {
            var (distance, motion, fraction) = Foot(point.Place);
            if (distance <= furthestMm)
            {
                feet.Add((starts[motion - first] + (fraction * path.Motions[motion].PlaneLength), motion, fraction, point));
            }
        }

        feet.Sort((a, b) => a.Along.CompareTo(b.Along));
        for (var i = 1; i < feet.Count; i++)
        {
            if (feet[i].Along - feet[i - 1].Along < 1e-6 && feet[i].Point.By != feet[i - 1].Point.By)
            {
                return Refuse(feet[i].Motion, NcRefusalCodes.PointsCoincide, string.Create(CultureInfo.InvariantCulture, $"the points {feet[i - 1].Point.Place} and {feet[i].Point.Place} have one foot on the path and different displacements. Leave one out."));
            }
        }

        return feet.Count > 0 ? null : Refuse(first, NcRefusalCodes.RunWithoutPoint, "the named blocks from here on, up to the next gap between them, have no point. Give one, or leave the blocks out.");
    }

    /// <summary>What is asked of each motion.</summary>
    public IEnumerable<ElementWish> Elements()
    {
        for (var i = 0; i + 1 < starts.Length; i++)
        {
            yield return new(first + i, At(starts[i]), At((starts[i] + starts[i + 1]) / 2), At(starts[i + 1]));
        }
    }

    /// <summary>By how much each point's motion, displaced as asked at its start, middle and end, misses what was asked at the point itself.</summary>
    public IEnumerable<(DisplacedPoint Point, double Millimeters)> Misfits()
    {
        foreach (var (_, motion, f, point) in feet)
        {
            var (start, middle, end) = (At(starts[motion - first]), At((starts[motion - first] + starts[motion - first + 1]) / 2), At(starts[motion - first + 1]));
            var moved = path.Motions[motion].IsArc
                ? (start * ((1 - f) * (1 - (2 * f)))) + (middle * (4 * f * (1 - f))) + (end * (f * ((2 * f) - 1)))
                : start + ((end - start) * f);
            yield return (point, (moved - point.By).Length);
        }
    }

    private (double DistanceMm, int Motion, double Fraction) Foot(Point2 place)
    {
        var best = (DistanceMm: double.PositiveInfinity, Motion: first, Fraction: 0.0);
        for (var i = 0; i + 1 < starts.Length; i++)
        {
            var motion = path.Motions[first + i];
            var fraction = motion.IsArc ? motion.Arc.NearestFraction(place) : motion.Segment.NearestFraction(place);
            var distance = motion.PlaneAt(fraction).DistanceTo(place);
            if (distance < best.DistanceMm)
            {
                best = (distance, first + i, fraction);
            }
        }

        return best;
    }

    private Vector2 At(double along)
    {
        var next = feet.FindIndex(f => f.Along >= along);
        if (next < 0)
        {
            return feet[^1].Point.By;
        }

        if (next == 0)
        {
            return feet[0].Point.By;
        }

        var (from, to) = (feet[next - 1], feet[next]);
        return from.Point.By + ((to.Point.By - from.Point.By) * ((along - from.Along) / (to.Along - from.Along)));
    }

    private NcRefusal Refuse(int motion, string code, string message) => NcRefusal.At(path.Program, path.Motions[motion].Block, code, message);
}
