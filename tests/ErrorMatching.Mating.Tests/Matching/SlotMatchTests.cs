using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Slots and keys by closed forms.</summary>
public sealed class SlotMatchTests
{
    private const string Head = "%\nO1000\nN10 G21 G90 G17\n", Tail = "N90 M30\n%\n";

    /// <summary>
    /// A slot of 20 mm width and 60 mm length about (0, 0) along x, by the center of a tool of 6 mm: half circles of radius 7 about (20,
    /// 0) and (-20, 0); the tool comes to the middle of a flank.
    /// </summary>
    private const string Slot = Head
        + "N20 G0 X0. Y0.\nN30 G1 Y-7. F300\nN40 X20.\nN50 G3 Y7. I0. J7.\nN60 G1 X-20.\nN70 G3 Y-7. I0. J-7.\nN80 G1 X0.\nN85 Y0.\n"
        + Tail;

    /// <summary>The same with ends of two quarters each, and the way in to a joint of flank and end.</summary>
    private const string Quarters = Head
        + "N20 G0 X-20. Y0.\nN30 G1 Y-7. F300\nN40 X20.\nN50 G3 X27. Y0. I0. J7.\nN55 X20. Y7. I-7. J0.\nN60 G1 X-20.\nN70 G3 X-27. Y0. "
            + "I0. J-7.\nN80 X-20. Y-7. I7. J0.\nN85 G1 Y0.\n"
        + Tail;

    /// <summary>A key of the same size under cutter compensation, clockwise, the tool outside.</summary>
    private const string Key = Head
        + "N20 G0 X0. Y-20.\nN30 G1 G41 D1 Y-10. F300\nN40 X-20.\nN50 G2 Y10. I0. J10.\nN60 G1 X20.\nN70 G2 Y-10. I0. J-10.\nN80 G1 "
            + "X0.\nN85 G40 Y-20.\n"
        + Tail;

    private const string Points = """[["1", "2"], ["3", "4"], ["5", "6"], ["7", "8"]]""";

    /// <summary>Middle, direction, half the width, half the distance of the ends' centers.</summary>
    private static readonly (Point2 Middle, double Degrees, double Radius, double Half) Nominal = (new(0, 0), 0, 10, 20);

    public static TheoryData<string, double, double, double, double, double> Cases => new()
    {
        { Slot, 0, 0, 0, 0.04, 0 },
        { Slot, 0.03, -0.02, 0, 0, 0 },
        { Slot, 0, 0, 0.05, 0, 0 },
        { Slot, 0, 0, 0, 0, 0.05 },
        { Slot, 0.03, -0.02, 0.04, -0.03, 0.05 },
        { Quarters, 0.03, -0.02, 0.04, -0.03, 0.05 },
        { Quarters, -0.01, 0.02, -0.03, 0.02, -0.04 },
        { Key, 0.03, -0.02, 0.04, -0.03, 0.05 },
    };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Flanks_and_ends_follow_the_part(string program, double x, double y, double degrees, double radius, double half)
    {
        var wanted = (Middle: new Point2(x, y), Degrees: degrees, Radius: 10 + radius, Half: 20 + half);
        var match = Match(program, Places(program, Nominal), Places(program, wanted));
        var after = match.Match().After;
        var direction = Vector2.FromDirection(Angle.FromDegrees(degrees));
        var inside = program == Key ? 0 : 3;
        foreach (var motion in Motions(match, after))
        {
            if (motion.IsArc)
            {
                Assert.Equal(wanted.Radius - inside, motion.Arc.Radius, 0.0012);
                Assert.InRange(
                    Math.Min(
                        motion.Center.DistanceTo(wanted.Middle + (direction * wanted.Half)),
                        motion.Center.DistanceTo(wanted.Middle - (direction * wanted.Half))),
                    0,
                    0.0012);
            }
            else
            {
                Assert.All(
                    [motion.PlaneStart, motion.PlaneEnd],
                    p => Assert.Equal(wanted.Radius - inside, Math.Abs((p - wanted.Middle).Cross(direction)), 0.0008));
            }
        }

        Assert.All(match.Report().KeyPoints, p => Assert.InRange(Math.Abs(p.PredictedMm), 0, 0.0012));
        AssertQuantity(match, "widthMm", 20, 2 * wanted.Radius);
        AssertQuantity(match, "lengthMm", 60, 2 * (wanted.Radius + wanted.Half));
        AssertQuantity(match, "centerXMm", 0, x);
        AssertQuantity(match, "centerYMm", 0, y);
        Assert.Equal(degrees, -Quantity(match, "directionDeg").Deviation, 1e-5);
    }

    [Fact]
    public void Blocks_and_points_that_are_no_slot_are_refused()
    {
        var places = Places(Slot, Nominal);
        Assert.Equal(
            "not-a-slot: S1, N30: it is neither a flank nor a round end of a slot. Name the two flanks and the two ends alone, without "
                + "the way in and out.",
            Refused(Match(Slot, places, places, "N30..N80")));
        Assert.Equal(
            "not-a-slot: S1, N50: the point 3 lies at a round end; expected a flank. Name the points of a flank, of the end behind it, "
                + "of the other flank and of the other end.",
            Refused(Match(Slot, places, places, points: """[["1", "3"], ["2", "4"], ["5", "6"], ["7", "8"]]""")));
    }

    [Fact]
    public void A_slot_that_would_be_narrower_than_the_tool_is_refused()
    {
        // The tool runs on ends of radius 0.02: a slot of 6.04 mm. 0.05 less is nothing.
        var narrow = Head
            + "N20 G0 X0. Y0.\nN30 G1 Y-0.02 F300\nN40 X20.\nN50 G3 Y0.02 I0. J0.02\nN60 G1 X-20.\nN70 G3 Y-0.02 I0. J-0.02\nN80 G1 "
                + "X0.\nN85 Y0.\n"
            + Tail;
        Assert.Equal(
            "slot-vanishes: S1, N40: displaced as asked, its ends would have a radius of -0.030 mm and its flanks a length of 40.000 mm. "
                + "The tool is too large for this slot, or the points are wrong.",
            Refused(Match(narrow, Places(narrow, Nominal with { Radius = 3.02 }), Places(narrow, Nominal with { Radius = 2.97 }))));
    }

    private static MatchCase Match(string program, string theoretical, string part, string blocks = "N40..N80", string points = Points) =>
        new(program)
        {
            Theoretical = theoretical,
            Part = part,
            Features = [MatchCase.Feature("slot", "S1", blocks, points)],
        };

    // Two points on each flank and end in the order of cutting, where the rays and normals of the nominal slot meet the slot that is
    // asked for.
    private static string Places(string program, (Point2 Middle, double Degrees, double Radius, double Half) slot)
    {
        var (nominal, turn) = (slot.Radius == 3.02 || slot.Radius == 2.97 ? 3.02 : 10.0, program == Key ? -1 : 1);
        (Point2 At, Vector2 Normal)[] from =
        [
            (new(turn * -12, -nominal), new(0, -1)), (new(turn * 11, -nominal), new(0, -1)),
            .. new[]
            {
                -40.0,
                30
            }.Select(a => Vector2.FromDirection(Angle.FromDegrees(
                turn > 0 ? a : 180 - a))).Select(r => (new Point2(turn * 20, 0) + (r * nominal), r)),
            (new(turn * 13, nominal), new(0, 1)), (new(turn * -10, nominal), new(0, 1)),
            .. new[]
            {
                150.0,
                215
            }.Select(a => Vector2.FromDirection(Angle.FromDegrees(
                turn > 0 ? a : 180 - a))).Select(r => (new Point2(turn * -20, 0) + (r * nominal), r)),
        ];
        return string.Join(
            "; ",
            from.Select(
                (f, i) => string.Create(
                    CultureInfo.InvariantCulture, $"{i + 1} {Meet(f.At, f.Normal, slot).X:R} {Meet(f.At, f.Normal, slot).Y:R}")));
    }

    // Bisection of the distance to the axis's segment, which is the slot's only definition here.
    private static Point2 Meet(Point2 at, Vector2 normal, (Point2 Middle, double Degrees, double Radius, double Half) slot)
    {
        var direction = Vector2.FromDirection(Angle.FromDegrees(slot.Degrees));
        var (low, high) = (-1.0, 1.0);
        for (var i = 0; i < 80; i++)
        {
            var middle = (low + high) / 2;
            var place = at + (normal * middle);
            var along = Math.Clamp((place - slot.Middle).Dot(direction), -slot.Half, slot.Half);
            (low, high) = place.DistanceTo(slot.Middle + (direction * along)) < slot.Radius ? (middle, high) : (low, middle);
        }

        return at + (normal * low);
    }

    private static Nc.NcMotion[] Motions(MatchCase match, Nc.NcPath after) =>
        [.. match.Match().Maps[0].Passes.SelectMany(p => Enumerable.Range(p.First, p.Last - p.First + 1)).Select(m => after.Motions[m])];

    private static string Refused(MatchCase match)
    {
        var refusal = Assert.Single(match.Outcome.Refusals);
        return $"{refusal.Code}: {refusal.Message}";
    }

    private static FeatureQuantity Quantity(MatchCase match, string name) =>
        match.Report().Features[0].Quantities.Single(q => q.Quantity.Name == name).Quantity;

    private static void AssertQuantity(MatchCase match, string name, double theoretical, double actual)
    {
        Assert.Equal(theoretical, Quantity(match, name).Theoretical, 1e-6);
        Assert.Equal(actual, Quantity(match, name).Actual, 2e-6);
    }
}
