using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Consecutive cutting motions, measured by length, with the wished displacements at places along them.</summary>
internal sealed class WishedRun
{
    private readonly NcPath _path;
    private readonly int _first;
    private readonly double[] _starts;
    private readonly List<(double Along, int Motion, double Fraction, DisplacedPoint Point)> _feet = [];

    /// <summary>Creates a run.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="first">Its first motion.</param>
    /// <param name="last">Its last motion.</param>
    public WishedRun(NcPath path, int first, int last)
    {
        (_path, _first) = (path, first);
        _starts = new double[last - first + 2];
        for (var i = 1; i < _starts.Length; i++)
        {
            _starts[i] = _starts[i - 1] + path.Motions[first + i - 1].PlaneLength;
        }
    }

    /// <summary>Its first motion.</summary>
    public int First => _first;

    /// <summary>Adds a point on the run.</summary>
    public void Add(DisplacedPoint point, PathFoot foot) =>
        _feet.Add(
            (_starts[foot.Motion - _first] + (foot.Fraction * _path.Motions[foot.Motion].PlaneLength), foot.Motion, foot.Fraction, point));

    /// <summary>Sorts the points along the run.</summary>
    /// <returns>A refusal if there are none, or if two of them disagree.</returns>
    public Refusal? Sort()
    {
        _feet.Sort((a, b) => a.Along.CompareTo(b.Along));
        for (var i = 1; i < _feet.Count; i++)
        {
            if (_feet[i].Along - _feet[i - 1].Along < 1e-6 && _feet[i].Point.By != _feet[i - 1].Point.By)
            {
                return Refuse(
                    _feet[i].Motion,
                    NcRefusalCodes.PointsCoincide,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"the points {_feet[i - 1].Point.Place} and {_feet[i].Point.Place} have one foot on the path and different "
                            + $"displacements. Leave one out."));
            }
        }

        return _feet.Count > 0
            ? null
            : Refuse(
                _first,
                NcRefusalCodes.RunWithoutPoint,
                "the named blocks from here on, up to the next gap between them, have no point. Give one, or leave the blocks out.");
    }

    /// <summary>The wish for each motion.</summary>
    public IEnumerable<ElementWish> Elements()
    {
        for (var i = 0; i + 1 < _starts.Length; i++)
        {
            yield return new(_first + i, At(_starts[i]), At((_starts[i] + _starts[i + 1]) / 2), At(_starts[i + 1]));
        }
    }

    /// <summary>For each point, how far its motion, displaced at its start, middle and end, misses the wish at the point itself.</summary>
    public IEnumerable<(DisplacedPoint Point, double Millimeters)> Misfits()
    {
        foreach (var (_, motion, f, point) in _feet)
        {
            var (start, middle, end) = (
                At(_starts[motion - _first]),
                At((_starts[motion - _first] + _starts[motion - _first + 1]) / 2),
                At(_starts[motion - _first + 1]));
            var moved = _path.Motions[motion].IsArc
                ? (start * ((1 - f) * (1 - (2 * f)))) + (middle * (4 * f * (1 - f))) + (end * (f * ((2 * f) - 1)))
                : start + ((end - start) * f);
            yield return (point, (moved - point.By).Length);
        }
    }

    private Vector2 At(double along)
    {
        var (next, end) = (0, _feet.Count);
        while (next < end)
        {
            var middle = (next + end) / 2;
            (next, end) = _feet[middle].Along >= along ? (next, middle) : (middle + 1, end);
        }

        if (next == _feet.Count)
        {
            return _feet[^1].Point.By;
        }

        if (next == 0)
        {
            return _feet[0].Point.By;
        }

        var (from, to) = (_feet[next - 1], _feet[next]);
        return from.Point.By + ((to.Point.By - from.Point.By) * ((along - from.Along) / (to.Along - from.Along)));
    }

    private Refusal Refuse(int motion, string code, string message) =>
        BlockRefusal.At(_path.Program, _path.Motions[motion].Block, code, message);
}
