using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Random outlines against exact distances of the moved polygons, searched without gradients.</summary>
public sealed class PairRefereeTests
{
    private const double Near = 0.001;

    [Fact]
    public void Three_hundred_random_pairs_seat_touch_and_play_as_their_moved_outlines_do()
    {
        var random = new Random(2026);
        var (together, overlapping, hollow, off) = (0, 0, 0, new List<string>());
        for (var pair = 0; pair < 300; pair++)
        {
            var isHollow = pair % 2 == 1;
            var (pocket, part, samples) = Pair(random, isHollow);
            hollow += isHollow ? 1 : 0;
            var (seat, motions) = (PairSeatTests.Seat(samples), PairSeatTests.Motions(samples));
            var referee = new PolygonReferee(pocket, part, motions.Center);
            var expected = referee.MostAir();
            (together, overlapping) = (together + (expected > 0 ? 1 : 0), overlapping + (expected > 0 ? 0 : 1));
            Check("air", expected, seat.TightestMm!.Value);
            Check("air at the seat", expected, referee.AirAt(seat.Shift.X, seat.Shift.Y, seat.Turn.Radians));
            foreach (var contact in seat.Contacts)
            {
                Check(
                    "contact",
                    expected,
                    referee.AirOf(samples[contact].Place, seat.Shift.X, seat.Shift.Y, seat.Turn.Radians));
            }

            Assert.Equal(seat.TightestMm >= -1e-9, seat.Play is not null);
            if (seat.Play is not { } play || Math.Abs(expected) < 2 * Near)
            {
                continue;
            }

            var (range, part3) = (pair / 2 % 3) switch
            {
                0 => (play.XMm, 0),
                1 => (play.YMm, 1),
                _ => (play.TurnDeg, 2),
            };
            var (end, sign) = pair % 4 < 2 ? (range!.Value.To, 1) : (range!.Value.From, -1);
            var (at, near) = part3 == 2 ? (end * Math.PI / 180, Near / motions.ArmMm) : (end, Near);
            if (!(referee.MostAir(part3, at - (sign * near)) > 0) || !(referee.MostAir(part3, at + (sign * near)) < 0))
            {
                off.Add($"pair {pair}: play of part {part3} ends at {at}");
            }

            void Check(string what, double wanted, double found)
            {
                if (Math.Abs(wanted - found) > Near)
                {
                    off.Add($"pair {pair}: {what} {found}, expected {wanted}");
                }
            }
        }

        Assert.True(off.Count == 0, $"{off.Count}: {string.Join('\n', off.Take(10))}");
        Assert.True(together > 80 && overlapping > 80 && hollow == 150, $"{together} together, {overlapping} overlapping");
    }

    // A pocket, and a part whose edges are displaced and tilted; the samples are those of its edges.
    private static ((double X, double Y)[] Pocket, (double X, double Y)[] Part, PairSample[] Samples) Pair(Random random, bool isHollow)
    {
        while (true)
        {
            var n = random.Next(4, 8);
            Point2[] pocket = [
                .. Enumerable.Range(0, n).Select(i => Point2.Origin + (Vector2.FromDirection(
                        Angle.FromDegrees((i + (0.4 * random.NextDouble())) * 360 / n))
                    * (isHollow ? 12 + (14 * random.NextDouble()) : 20)))];
            Vector2[] along = [.. pocket.Select((p, i) => (pocket[(i + 1) % n] - p).Normalize())];
            double[] turns = [.. along.Select((a, i) => along[(i + n - 1) % n].Cross(a))];
            if (turns.Any(t => Math.Abs(t) < 0.35) || turns.Any(t => t < 0) != isHollow
                || pocket.Select((p, i) => pocket[(i + 1) % n].DistanceTo(p)).Min() < 8)
            {
                continue;
            }

            var air = -0.025 + (0.06 * random.NextDouble());
            var lines = pocket.Select((p, i) => (
                From: p + (along[i].Left * (air + (0.02 * (random.NextDouble() - 0.5)))),
                To: pocket[(i + 1) % n] + (along[i].Left * (air + (0.02 * (random.NextDouble() - 0.5)))))).ToArray();
            Point2[] part = [.. lines.Select((l, i) => Meeting(lines[(i + n - 1) % n], l))];
            PairSample[] samples = [
                .. part.SelectMany((p, i) => Enumerable.Range(0, 6).Select(k => p.Lerp(part[(i + 1) % n], k / 5.0)).Select(
                    place => new PairSample(place, along[i].Left, (place - pocket[i]).Dot(along[i].Left))))];
            return ([.. pocket.Select(p => (p.X, p.Y))], [.. part.Select(p => (p.X, p.Y))], samples);
        }
    }

    private static Point2 Meeting((Point2 From, Point2 To) one, (Point2 From, Point2 To) other)
    {
        var (a, b) = (one.To - one.From, other.To - other.From);
        return one.From + (a * ((other.From - one.From).Cross(b) / a.Cross(b)));
    }
}
