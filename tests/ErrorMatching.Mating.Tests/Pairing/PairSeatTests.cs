using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Seats, contacts and play by closed forms.</summary>
public sealed class PairSeatTests
{
    private const double Width = 40, Height = 24;

    // Clearance of the key at each side of its slot.
    [Theory]
    [InlineData(0.02, 0.02, 0.05, 0.05)]
    [InlineData(0.03, 0.01, 0.05, 0.02)]
    [InlineData(0.01, 0.05, 0.04, 0.08)]
    public void A_key_in_a_slot_has_half_the_clearance_and_plays_by_all_of_it(double left, double right, double below, double above)
    {
        var seat = Seat(Key(left, right, below, above));
        Assert.Equal(Math.Min(left + right, below + above) / 2, seat.TightestMm!.Value, 1e-9);
        Assert.Equal(((right - left) / 2, (above - below) / 2), (seat.Shift.X, seat.Shift.Y), new Near(1e-8));
        AssertRange(-left, right, seat.Play!.XMm);
        AssertRange(-below, above, seat.Play.YMm);

        // Turned by w, a corner goes w H/2 across and w W/2 up, whatever the shift: both clearances must hold it.
        var turn = Angle.FromRadians(Math.Min((left + right) / Height, (below + above) / Width)).Degrees;
        AssertRange(-turn, turn, seat.Play.TurnDeg, 1e-7);
    }

    [Theory]
    [InlineData(0.03, 0, 0)]
    [InlineData(0.03, 0.02, -0.05)]
    public void A_round_boss_in_a_bore_has_half_the_clearance_whatever_the_direction(double clearance, double aside, double up)
    {
        var center = new Point2(7, -3);
        var bore = Around(72).Select(n => new PairSample(
            center - (n * 10), n, (clearance / 2) + new Vector2(aside, up).Dot(n))).ToArray();
        var seat = Seat(bore);
        Assert.Equal(clearance / 2, seat.TightestMm!.Value, 1e-9);
        Assert.Equal((-aside, -up), (seat.Shift.X, seat.Shift.Y), new Near(1e-8));
        Assert.Null(seat.Play!.TurnDeg);

        // 72 sides of a polygon: exact along an axis, which is the normal of one of them.
        AssertRange(-aside - (clearance / 2), -aside + (clearance / 2), seat.Play.XMm);
        AssertRange(-up - (clearance / 2), -up + (clearance / 2), seat.Play.YMm);
    }

    [Fact]
    public void A_boss_that_is_measured_on_one_side_turns_about_its_own_center()
    {
        var normals = Around(72).Where(n => n.X > -0.7).ToArray();
        var seat = Seat([.. normals.Select(n => new PairSample(new Point2(5, 5) - (n * 10), n, 0.01))]);
        Assert.Null(seat.Play!.TurnDeg);
        AssertRange(-0.01, 0.01, seat.Play.YMm);
    }

    [Fact]
    public void A_rail_is_free_along_itself_and_stays_where_it_is()
    {
        var rail = Line(new(0, 0), new(60, 0), new(0, 1), 0.02).Concat(Line(new(0, 20), new(60, 20), new(0, -1), 0.04)).ToArray();
        var seat = Seat(rail);
        Assert.Equal(0.03, seat.TightestMm!.Value, 1e-9);
        Assert.Equal((0, 0.01), (seat.Shift.X, seat.Shift.Y), new Near(1e-8));
        Assert.Null(seat.Play!.XMm);
        AssertRange(-0.02, 0.04, seat.Play.YMm);
        var turn = Angle.FromRadians(0.06 / 60).Degrees;
        AssertRange(-turn, turn, seat.Play.TurnDeg, 1e-7);
    }

    [Fact]
    public void An_interference_is_where_the_key_is_too_wide()
    {
        // One side has a bump of 0.06 at its middle, the other leaves 0.02: overlap 0.02 on each side, at the bump and both ends opposite.
        var key = Key(0.02, 0.02, 0.05, 0.05).Select(
            s => s.Normal.X > 0.5 && s.Place.Y == Height / 2 ? s with { GapMm = -0.06 } : s).ToArray();
        var seat = Seat(key);
        Assert.Equal(-0.02, seat.TightestMm!.Value, 1e-9);
        Assert.Null(seat.Play);
        Assert.Contains(seat.Contacts, c => key[c].Normal.X > 0.5 && key[c].Place.Y == Height / 2);
        Assert.Contains(seat.Contacts, c => key[c].Normal.X < -0.5);
        Assert.InRange(seat.Contacts.Count, 2, 4);
        Assert.All(seat.Contacts, c => Assert.Equal(-0.02, seat.GapsMm[c], 1e-8));
        Assert.Equal(-0.02, seat.GapsMm.Min(), 1e-8);
    }

    [Fact]
    public void A_part_that_can_be_lifted_off_is_pressed_home()
    {
        // A notch of two flanks at 45 degrees, open upward; the part is narrower by 0.01 at each flank.
        var s = Math.Sqrt(0.5);
        var notch = Line(new(-10, 10), new(0, 0), new(s, s), 0.01).Concat(Line(new(0, 0), new(10, 10), new(-s, s), 0.01)).ToArray();
        var seat = Seat(notch);
        Assert.Null(seat.TightestMm);
        Assert.Equal((0, -0.01 / s), (seat.Shift.X, seat.Shift.Y), new Near(1e-7));
        Assert.All(seat.GapsMm, g => Assert.Equal(0, g, 1e-7));
        Assert.Null(seat.Play!.YMm);
    }

    [Fact]
    public void The_seat_of_drawn_gaps_is_the_same_from_any_basis()
    {
        // Warm from the last basis, as for draws, against cold.
        var random = new Random(5);
        var key = Key(0, 0, 0, 0);
        var motions = Motions(key);
        double[] gaps = [.. key.Select(_ => 0.0)];
        var warm = motions.Seat(0);
        for (var draw = 0; draw < 500; draw++)
        {
            double[] drawn = [.. gaps.Select(_ => random.NextDouble() - 0.4)];
            var cold = motions.Seat(PairSeat.Smallest(drawn));
            Assert.True(warm.Solve(motions.Limits(drawn)) && cold.Solve(motions.Limits(drawn)));
            Assert.Equal(cold.Value, warm.Value, 1e-9);
        }
    }

    internal static PairSeat Seat(PairSample[] samples) => PairSeat.Find(Motions(samples), [.. samples.Select(s => s.GapMm)]);

    internal static PairMotions Motions(PairSample[] samples) => new(
        [.. samples.Select(s => s.Place)], [.. samples.Select(s => s.Normal)], samples.Max(s => Math.Abs(s.GapMm)));

    // A slot about the key; its normals point inward.
    private static PairSample[] Key(double left, double right, double below, double above) =>
        [
            .. Line(new(0, 0), new(Width, 0), new(0, 1), below),
            .. Line(new(Width, 0), new(Width, Height), new(-1, 0), right),
            .. Line(new(Width, Height), new(0, Height), new(0, -1), above),
            .. Line(new(0, Height), new(0, 0), new(1, 0), left),
        ];

    private static IEnumerable<PairSample> Line(Point2 from, Point2 to, Vector2 normal, double gap) =>
        Enumerable.Range(0, 11).Select(i => new PairSample(from.Lerp(to, i / 10.0), normal, gap));

    private static Vector2[] Around(int count) =>
        [.. Enumerable.Range(0, count).Select(i => Vector2.FromDirection(Angle.FromDegrees(360.0 * i / count)))];

    private static void AssertRange(double from, double to, PlayRange? range, double near = 1e-8)
    {
        Assert.Equal(from, range!.Value.From, near);
        Assert.Equal(to, range.Value.To, near);
    }

    private sealed class Near(double within) : IEqualityComparer<(double, double)>
    {
        public bool Equals((double, double) x, (double, double) y) =>
            Math.Abs(x.Item1 - y.Item1) <= within && Math.Abs(x.Item2 - y.Item2) <= within;

        public int GetHashCode((double, double) obj) => 0;
    }
}

internal sealed record PairSample(Point2 Place, Vector2 Normal, double GapMm);
