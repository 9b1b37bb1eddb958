using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Closed contours with a lead-in N1 and a lead-out N9, named with the ring N2 to N5 or not. Where the ring goes is worked out by hand:
/// a circle of 10 about the origin gets 10 less the displacement where it turns left, and so far from the origin are the sides of a square.
/// </summary>
public sealed class LeadTests
{
    private const double Radius = 10;

    private static readonly string[] Shapes = ["circle", "halves", "quarters", "square from a corner", "square from a side"];

    private static readonly string[] Leads =
        ["tangential line", "tangential arc", "square line from inside", "square line from outside", "oblique line"];

    public static TheoryData<string, bool> Rings => [.. Shapes.SelectMany(r => new[] { (r, true), (r, false) })];

    [Fact]
    public void A_lead_in_that_would_miss_its_ring_is_refused_with_what_to_name_instead()
    {
        var path = WrongProgram.Read("lead-in-named.nc", "fanuc");
        foreach (var left in (double[])[0.02, -0.02])
        {
            var both = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N2..N8"), left));
            var refusal = Bench.Refused(Rewriter.Apply(path, both));
            Assert.Equal((NcRefusalCodes.NoIntersection, "N2", 4), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
            Assert.Contains(" N3 to N8 ", refusal.Message, StringComparison.Ordinal);

            // And so it is: the square of 10 to 40 and 10 to 50, travelled clockwise, grows to the left; the lead-in ends at its corner.
            var alone = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N3..N8"), left));
            var now = NcInterpreter.Run(Bench.Rewritten(path, alone).Program, path.Dialect);
            var (low, right, top) = (10 - left, 40 + left, 50 + left);
            Point2[] corners = [new(low, low), new(low, top), new(right, top), new(right, low), new(low, low)];
            foreach (var (block, corner) in ((string[])["N2", "N3", "N4", "N5", "N8"]).Zip(corners))
            {
                Assert.Equal(0, Bench.MotionOf(now, block).PlaneEnd.DistanceTo(corner), 1e-9);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Rings))]
    public void A_ring_closes_where_its_offset_does_whatever_leads_to_it(string ring, bool counterClockwise)
    {
        foreach (var (leadIn, leadOut) in Leads.SelectMany(a => Leads.Select(b => (a, b))))
        {
            var text = Program(ring, counterClockwise, leadIn, leadOut);
            foreach (var left in (double[])[0.02, -0.02, 0.15, -0.15])
            {
                foreach (var named in (string[])["N2..N5", "N1..N5", "N2..N9", "N1..N9"])
                {
                    var mayMiss = (named[1] == '1' && !leadIn.StartsWith('t')) || (named[^1] == '9' && !leadOut.StartsWith('t'))
                        || (ring == "square from a corner" && named != "N2..N5");
                    try
                    {
                        Check(Bench.Read(text), ring, named, counterClockwise ? left : -left, left, mayMiss);
                    }
                    catch (Exception e)
                    {
                        throw new InvalidOperationException($"{leadIn}, {leadOut}, {named}, {left}:\n{text}", e);
                    }
                }
            }
        }
    }

    // A center that goes aside changes neither where the circle begins nor where it is half way round by more than a few micrometers.
    [Theory]
    [InlineData("J0.", "J0.1")]
    [InlineData("J0.", "J-0.02")]
    [InlineData("J0.", "J0.002")]
    [InlineData("I-9.98", "I-9.984")]
    public void A_full_circle_about_another_center_is_not_proved(string was, string now)
    {
        var path = Bench.Read("G21 G90 G17\nG0 X10. Y0.\nG1 Z-1. F100\nN2 G3 X10. Y0. I-10. J0.\nG0 Z5.\n");
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N2"), 0.02).Result!;
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        Assert.Contains("I-9.98 J0.", good, StringComparison.Ordinal);
        Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal)), wish, 0.001).Holds);
    }

    // Inward is where the ring gets smaller.
    private static void Check(NcPath path, string ring, string named, double inward, double left, bool mayMiss)
    {
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, named), left).Result!;
        var rewrite = Rewriter.Apply(path, wish);
        if (!rewrite.IsUsable)
        {
            Assert.True(mayMiss, rewrite.Refusal.Message);
            Assert.Equal(NcRefusalCodes.NoIntersection, rewrite.Refusal.Code);
            Assert.Contains(rewrite.Refusal.Place.Block, (string[])["N1", "N9"]);
            Assert.Contains("alone is named", rewrite.Refusal.Message, StringComparison.Ordinal);
            return;
        }

        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect).Motions;
        var (first, last) = (3, now.Length - 3);
        if (now[first].PlaneStart.DistanceTo(now[last].PlaneEnd) > 1e-9)
        {
            // Both leads go on along the sides of the corner, a line exactly, an arc of 3 nearly: they cross there, and the ring is whole.
            Assert.Equal(("N1..N9", "square from a corner"), (named, ring));
            var corner = Point2.Origin + ((path.Motions[first].PlaneStart - Point2.Origin) * ((Radius - inward) / Radius));
            Assert.InRange(Math.Min(Off(now[first - 1], corner), Off(now[first], corner)), 0, 0.0006 + (inward * inward / 5.6));
            Assert.InRange(Math.Min(Off(now[last], corner), Off(now[last + 1], corner)), 0, 0.0006 + (inward * inward / 5.6));
        }

        for (var i = first; i <= last; i++)
        {
            if (ring.StartsWith("square", StringComparison.Ordinal))
            {
                // Each side keeps its direction; its distance from the origin is that of its middle's larger coordinate.
                var line = now[i].Segment.Line;
                Assert.Equal(Radius - inward, Math.Abs(line.SignedDistance(Point2.Origin)), 0.00051);
                Assert.Equal(0, line.Direction.Cross(path.Motions[i].Segment.Line.Direction), 1e-9);
            }
            else
            {
                foreach (var fraction in (double[])[0, 0.25, 0.5, 0.75, 1])
                {
                    Assert.Equal(Radius - inward, now[i].PlaneAt(fraction).DistanceTo(Point2.Origin), 0.0016);
                }

                Assert.Equal(0, now[i].PlaneEnd.DistanceTo(path.Motions[i].PlaneEnd) - Math.Abs(inward), 0.0011);
            }
        }
    }

    private static double Off(NcMotion motion, Point2 place) =>
        motion.IsArc ? motion.Arc.DistanceTo(place) : motion.Segment.DistanceTo(place);

    // The ring begins on the right, at (10, 0), or at the corner (10, 10) of a square.
    private static string Program(string ring, bool counterClockwise, string leadIn, string leadOut)
    {
        var turn = counterClockwise ? 1 : -1;
        var start = new Point2(Radius, ring == "square from a corner" ? -Radius * turn : 0);
        var blocks = ring switch
        {
            "circle" => $"N2 {Arc(turn)} X10. Y0. I-10. J0.\nN5 G4 P1\n",
            "halves" => $"N2 {Arc(turn)} X-10. Y0. I-10. J0.\nN5 X10. Y0. I10. J0.\n",
            "quarters" => $"N2 {Arc(turn)} X0. Y{10 * turn}. I-10. J0.\nN3 X-10. Y0. I0. J{-10 * turn}.\n"
                + $"N4 X0. Y{-10 * turn}. I10. J0.\nN5 X10. Y0. I0. J{10 * turn}.\n",
            "square from a corner" => $"N2 G1 X10. Y{10 * turn}.\nN3 X-10.\nN4 Y{-10 * turn}.\nN5 X10.\n",
            _ => $"N2 G1 X10. Y{10 * turn}.\nN3 X-10.\nN4 Y{-10 * turn}.\nN45 X10.\nN5 Y0.\n",
        };
        // Both leads are tangential to the side on the right.
        var (from, inBlock) = Lead(leadIn, start, turn, -1);
        var (to, outBlock) = Lead(leadOut, start, turn, 1);
        var head = string.Create(CultureInfo.InvariantCulture, $"G21 G90 G17\nG0 X{from.X:0.0##} Y{from.Y:0.0##} Z5.\nG1 Z-1. F100\n");
        return $"{head}N1 {inBlock(start)}\n{blocks}N9 {outBlock(to)}\nG0 Z5.\nM30\n";
    }

    private static string Arc(int turn) => turn > 0 ? "G3" : "G2";

    // The other end of a lead, and its block to an end. Travel at the start is (0, turn).
    private static (Point2 Far, Func<Point2, string> Block) Lead(string kind, Point2 start, int turn, int sign)
    {
        string Line(Point2 end) => string.Create(CultureInfo.InvariantCulture, $"G1 X{end.X:0.0##} Y{end.Y:0.0##} F100");
        switch (kind)
        {
            case "tangential line":
                return (start + new Vector2(0, 3 * turn * sign), Line);
            case "tangential arc":
                // A quarter of a circle of 3 on the outside, about (start.X + 3, start.Y): it turns against the ring.
                var far = start + new Vector2(3, 3 * turn * sign);
                var center = sign < 0 ? $"I0. J{3 * turn}." : "I3. J0.";
                return (far, end => string.Create(
                    CultureInfo.InvariantCulture, $"{Arc(-turn)} X{end.X:0.0##} Y{end.Y:0.0##} {center} F100"));
            case "square line from inside":
                return (start + new Vector2(-3, 0), Line);
            case "square line from outside":
                return (start + new Vector2(3, 0), Line);
            default:
                return (start + new Vector2(3, 3 * turn * sign), Line);
        }
    }
}
