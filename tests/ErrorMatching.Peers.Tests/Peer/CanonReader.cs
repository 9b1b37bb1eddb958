using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>Reads the canonical commands that the peer prints, one a line, such as <c>9 N2 STRAIGHT_FEED(5.0000, 2.0000, 3.0000, 0.0000,
/// 0.0000, 0.0000)</c>.</summary>
internal sealed class CanonReader
{
    private const double LastDigit = 0.0001;

    private readonly List<PeerMotion> _motions = [];
    private double _unit = 1;
    private double _feed;
    private bool _perMinute = true;
    private bool _inverseTime;
    private CoordinatePlane _plane;
    private int? _line;

    private double? Feed => _perMinute && !_inverseTime ? _feed : null;

    public IReadOnlyList<PeerMotion> Read(IEnumerable<string> lines)
    {
        foreach (var line in lines)
        {
            Read(line);
        }

        return _motions;
    }

    private void Read(string line)
    {
        var open = line.IndexOf('(', StringComparison.Ordinal);
        var parts = line.Split(' ', 3, StringSplitOptions.RemoveEmptyEntries);
        if (open < 0 || parts.Length < 3 || !parts[1].StartsWith('N'))
        {
            return;
        }

        _line = int.TryParse(parts[1].AsSpan(1), CultureInfo.InvariantCulture, out var number) ? number : null;
        var command = parts[2][..parts[2].IndexOf('(', StringComparison.Ordinal)].Trim();
        var arguments = line[(open + 1)..line.LastIndexOf(')')];
        switch (command)
        {
            case "USE_LENGTH_UNITS":
                _unit = arguments switch { "CANON_UNITS_MM" => 1, "CANON_UNITS_INCHES" => 25.4, _ => throw new FormatException(line) };
                break;
            case "SELECT_PLANE":
                _plane = arguments switch
                {
                    "CANON_PLANE_XY" => CoordinatePlane.XY,
                    "CANON_PLANE_XZ" => CoordinatePlane.ZX,
                    "CANON_PLANE_YZ" => CoordinatePlane.YZ,
                    _ => throw new FormatException(line),
                };
                break;
            case "SET_FEED_RATE":
                _feed = Numbers(arguments)[0] * _unit;
                break;
            case "SET_FEED_MODE":
                _perMinute = Numbers(arguments)[1] == 0;
                break;

            // Inverse time is announced by a comment, then by the same command as feed per minute.
            case "COMMENT" when arguments.Contains("feed mode set to", StringComparison.Ordinal):
                _inverseTime = arguments.Contains("inverse", StringComparison.Ordinal);
                break;
            case "STRAIGHT_TRAVERSE":
                Add(MotionKind.Rapid, Numbers(arguments));
                break;
            case "STRAIGHT_FEED":
                Add(MotionKind.Line, Numbers(arguments));
                break;
            case "STRAIGHT_PROBE":
                Add(MotionKind.Probe, Numbers(arguments));
                break;
            case "ARC_FEED":
                AddArc(Numbers(arguments));
                break;
            case "NURBS_FEED":
                _motions.Add(new(_line, MotionKind.Line, _plane, default, default, 0, Feed, _unit * LastDigit, IsSpline: true));
                break;
        }
    }

    private void Add(MotionKind kind, double[] n) =>
        _motions.Add(new(_line, kind, _plane, new(n[0] * _unit, n[1] * _unit, n[2] * _unit), default, 0, Feed, _unit * LastDigit));

    // First end, second end, first center, second center, signed turns, end along the third axis: axes in the order of the plane.
    private void AddArc(double[] n)
    {
        var end = _plane.Lift(new(n[0] * _unit, n[1] * _unit), n[5] * _unit);
        var kind = n[4] > 0 ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise;
        _motions.Add(new(_line, kind, _plane, end, new(n[2] * _unit, n[3] * _unit), (int)Math.Abs(n[4]) - 1, Feed, _unit * LastDigit));
    }

    private static double[] Numbers(string arguments) =>
        [.. arguments.Split(',').Select(a => double.Parse(a.Trim(), NumberStyles.Float, CultureInfo.InvariantCulture))];
}
