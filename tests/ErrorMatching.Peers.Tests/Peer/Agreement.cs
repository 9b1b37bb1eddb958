using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>Compares our motions with the peer's, to the digits that the peer prints.</summary>
internal static class Agreement
{
    /// <summary>Axes of motion ends that a program may leave unknown to us: a generated one states what it uses.</summary>
    private const double MostUnknown = 0.02;

    /// <summary>The first difference as a sentence, or null where there is none.</summary>
    /// <param name="peer">The peer's motions.</param>
    /// <param name="path">Ours.</param>
    /// <param name="mostUnknown">The part of all coordinates that we may not know.</param>
    /// <param name="peerStops">True where the peer refused a block, so that we may have motions behind it.</param>
    public static string? FirstDifference(
        IReadOnlyList<PeerMotion> peer, NcPath path, double mostUnknown = MostUnknown, bool peerStops = false)
    {
        var unknown = 0;
        for (var i = 0; i < Math.Min(peer.Count, path.Motions.Length); i++)
        {
            var ours = path.Motions[i];
            unknown += System.Numerics.BitOperations.PopCount((uint)ours.UnknownEnd);
            if (Difference(peer[i], ours) is { } difference)
            {
                return $"motion {i}, line {ours.Block + 1} \"{path.Program.TextOf(path.Program[ours.Block])}\": {difference}\n  rs274: "
                    + $"{Show(peer[i])}\n  ours:  {Show(ours)}";
            }
        }

        if (peer.Count != path.Motions.Length && !(peerStops && peer.Count < path.Motions.Length))
        {
            return $"rs274 has {peer.Count} motions, we have {path.Motions.Length}";
        }

        return unknown > mostUnknown * 3 * peer.Count ? $"{unknown} of {3 * peer.Count} coordinates are unknown to us" : null;
    }

    private static string? Difference(PeerMotion peer, NcMotion ours)
    {
        if (peer.Line is { } line && line != ours.Block + 1)
        {
            return "block";
        }

        if (peer.IsSpline)
        {
            return null;
        }

        // Where the peer's machine has stored a place, ours goes by rapid to one that only the machine knows.
        var kind = ours.Kind == MotionKind.Reference && ours.UnknownEnd != AxisSet.None ? MotionKind.Rapid : ours.Kind;
        if (peer.Kind != kind)
        {
            return "kind";
        }

        if (ours.IsArc && peer.Plane != ours.Plane)
        {
            return "plane";
        }

        // Half of the last digit, and the noise of binary fractions.
        var tolerance = (0.5 * peer.ResolutionMm) + 1e-7;
        if (!Agree(AxisSet.X, peer.End.X, ours.End.X)
            || !Agree(AxisSet.Y, peer.End.Y, ours.End.Y)
            || !Agree(AxisSet.Z, peer.End.Z, ours.End.Z))
        {
            return "end";
        }

        if (ours.IsArc
            && (ours.UnknownStart & ours.Plane.Axes()) == AxisSet.None
            && !(Math.Abs(peer.Center.X - ours.Center.X) <= tolerance && Math.Abs(peer.Center.Y - ours.Center.Y) <= tolerance))
        {
            return "center";
        }

        if (peer.Turns != ours.Turns)
        {
            return "turns";
        }

        return kind != MotionKind.Rapid && peer.Feed is { } feed && !(Math.Abs(feed - ours.Feed) <= tolerance) ? "feed" : null;

        bool Agree(AxisSet axis, double theirs, double own) =>
            (ours.UnknownEnd & axis) != AxisSet.None || Math.Abs(theirs - own) <= tolerance;
    }

    private static AxisSet Axes(this CoordinatePlane plane) => plane switch
    {
        CoordinatePlane.XY => AxisSet.X | AxisSet.Y,
        CoordinatePlane.ZX => AxisSet.Z | AxisSet.X,
        _ => AxisSet.Y | AxisSet.Z
    };

    private static string Show(PeerMotion m) => string.Create(
        CultureInfo.InvariantCulture,
        $"N{m.Line} {m.Kind} {m.Plane} to {m.End.X:0.####} {m.End.Y:0.####} {m.End.Z:0.####} about {m.Center.X:0.####} "
            + $"{m.Center.Y:0.####} turns {m.Turns} feed {m.Feed:0.####}");

    private static string Show(NcMotion m) => string.Create(
        CultureInfo.InvariantCulture,
        $"N{m.Block + 1} {m.Kind} {m.Plane} to {m.End.X:0.####} {m.End.Y:0.####} {m.End.Z:0.####} about {m.Center.X:0.####} "
            + $"{m.Center.Y:0.####} turns {m.Turns} feed {m.Feed:0.####} unknown {m.UnknownEnd}");
}
