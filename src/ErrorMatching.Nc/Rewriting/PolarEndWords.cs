using System.Buffers;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The angle of an arc whose end is polar about its center (CP): the end lies on the circle through the start, so only the angle
/// can put it elsewhere.</summary>
/// <param name="path">The path.</param>
/// <param name="grid">The numbers that words can express.</param>
internal sealed class PolarEndWords(NcPath path, IncrementGrid grid)
{
    /// <summary>Decimals of an angle that the control takes, degrees.</summary>
    private const int AngleDecimals = 4;

    private static readonly SearchValues<byte> NumberBytes = SearchValues.Create("+-.0123456789"u8);

    /// <summary>The patch of an arc's angle, or none if its end comes near enough.</summary>
    /// <param name="index">The arc.</param>
    /// <param name="center">Its new center.</param>
    /// <param name="isPossible">False if the control computes the angle.</param>
    /// <param name="end">Where it ends then, in its plane.</param>
    public NcPatch? Patch(int index, Point2 center, out bool isPossible, out Point2 end)
    {
        var arc = path.Motions[index];
        var start = grid.Rounded(arc.Start, index, arc.Plane) - center;
        var wanted = grid.Rounded(arc.End, index + 1, arc.Plane) - center;
        var token = Angle(path.Motions.BlockOf(index));
        var bytes = path.Program.Bytes.Span.Slice(token.ValueStart, token.ValueLength);
        var (old, grows) = (token.Number.Value, token.Distance == WordDistance.Incremental);
        end = center + EndOf(start, old, grows);
        isPossible = token.Kind == NcTokenKind.PolarWord && !bytes.ContainsAnyExcept(NumberBytes);
        if (!isPossible || end.DistanceTo(center + wanted) <= grid.Increment / 2)
        {
            return null;
        }

        var degrees = grows
            ? Sweep(start, wanted, arc.Kind == MotionKind.ArcCounterClockwise)
            : Elementary.Atan2(wanted.Y, wanted.X) * 180 / Math.PI;
        degrees += grows ? 0 : 360 * Math.Round((old - degrees) / 360);
        var value = NcNumber.Round(degrees, Math.Max(AngleDecimals, token.Number.Decimals)).Trim();
        end = center + EndOf(start, value.Value, grows);
        var style = NumberStyle.Of(bytes, programIsFixed: false);
        return value.SameValue(token.Number) ? null : new NcPatch(token.ValueStart, token.ValueLength, style.Format(value));
    }

    private NcToken Angle(int block)
    {
        foreach (var token in path.Program.Tokens(path.Program[block]))
        {
            if (token is { Kind: NcTokenKind.PolarWord, Letter: (byte)'^' })
            {
                return token;
            }
        }

        return default;
    }

    private static Vector2 EndOf(Vector2 start, double degrees, bool grows)
    {
        var angle = (grows ? start.Direction.Radians : 0) + (degrees * Math.PI / 180);
        return Vector2.FromDirection(Geometry.Angle.FromRadians(angle)) * start.Length;
    }

    // A full turn if start and end are one direction.
    private static double Sweep(Vector2 start, Vector2 end, bool counterClockwise)
    {
        var degrees = Elementary.Atan2(start.Cross(end), start.Dot(end)) * 180 / Math.PI;
        const double Nothing = 1e-6;
        return counterClockwise
            ? (degrees > Nothing ? degrees : degrees + 360)
            : (degrees < -Nothing ? degrees : degrees - 360);
    }
}
