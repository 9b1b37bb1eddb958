namespace ErrorMatching.Mating;

/// <summary>The air at the tightest place for boundaries drawn from what is known about them.</summary>
/// <param name="Probability">Share of the boundaries that go together.</param>
/// <param name="MedianMm">The air that half of them exceed.</param>
/// <param name="FromMm">The air that 97.5 % of them exceed.</param>
/// <param name="ToMm">The air that 2.5 % of them exceed.</param>
internal sealed record PairDraws(double Probability, double MedianMm, double FromMm, double ToMm)
{
    /// <summary>Number of boundaries drawn: a probability to 1 %.</summary>
    public const int Count = 2000;

    // The first draws show which places are ever the tightest. The others look at those alone.
    private const int Pilot = 128;

    // A place takes no part if its distance from being the tightest is more than so many standard deviations.
    private const double Far = 4;

    // The same numbers for the same input, on every system.
    private const ulong Seed = 0x0123456789ABCDEF;

    /// <summary>Draws boundaries.</summary>
    /// <param name="motions">The motions of the places.</param>
    /// <param name="gaps">The expected gaps.</param>
    /// <param name="factors">What is not known about them.</param>
    /// <param name="count">Number of boundaries, even.</param>
    public static PairDraws Draw(PairMotions motions, IReadOnlyList<double> gaps, IReadOnlyList<JointFactor> factors, int count = Count)
    {
        var variates = new NormalVariates(Seed);
        var air = new List<double>(count);
        var all = new DrawnGaps(motions, [.. gaps], factors);
        if (count > 2 * Pilot)
        {
            var slack = new (double Sum, double Squares)[motions.Count];
            all.Draw(Pilot, variates, air, slack);
            int[] kept = [.. Enumerable.Range(0, slack.Length).Where(k => IsNear(slack[k]))];
            all = all.Only(kept);
        }

        all.Draw(count - air.Count, variates, air, null);
        air.Sort();
        return new(air.Count(m => PairSeat.GoesTogether(m)) / (double)air.Count, At(0.5), At(0.025), At(0.975));

        static bool IsNear((double Sum, double Squares) slack)
        {
            var mean = slack.Sum / Pilot;
            return mean < Far * Math.Sqrt(Math.Max(0, (slack.Squares / Pilot) - (mean * mean))) || mean < 1e-9;
        }

        double At(double share)
        {
            var place = share * (air.Count - 1);
            var below = (int)place;
            return air[below] + ((air[Math.Min(below + 1, air.Count - 1)] - air[below]) * (place - below));
        }
    }

    // Draws of the gaps at some places, and the seat of each.
    private sealed class DrawnGaps
    {
        private readonly PairMotions _motions;
        private readonly double[] _gaps;
        private readonly IReadOnlyList<JointFactor> _factors;
        private readonly LinearProgram _seat;

        public DrawnGaps(PairMotions motions, double[] gaps, IReadOnlyList<JointFactor> factors)
        {
            (_motions, _gaps, _factors) = (motions, gaps, factors);
            _seat = motions.Seat(PairSeat.Smallest(gaps));
        }

        public DrawnGaps Only(IReadOnlyList<int> kept) => new(
            _motions.Of(kept),
            [.. kept.Select(k => _gaps[k])],
            [.. _factors.Select(f => Only(f, kept)).Where(f => f.Columns.Count > 0 && f.Columns[0].Length > 0)]);

        // Places of one factor follow one another, kept or not.
        private static JointFactor Only(JointFactor factor, IReadOnlyList<int> kept)
        {
            var length = factor.Columns.Count == 0 ? 0 : factor.Columns[0].Length;
            int[] own = [.. kept.Where(k => k >= factor.First && k < factor.First + length)];
            return new(
                kept.Count(k => k < factor.First),
                [.. factor.Columns.Select(c => own.Select(k => c[k - factor.First]).ToArray())]);
        }

        // Each draw and its mirror image, so that the draws have the expected gaps as their mean.
        public void Draw(int count, NormalVariates variates, List<double> air, (double Sum, double Squares)[]? slack)
        {
            var (off, limits) = (new double[_gaps.Length], _motions.Limits(_gaps));
            for (var draw = 0; draw < count; draw += 2)
            {
                Array.Clear(off);
                foreach (var factor in _factors)
                {
                    foreach (var column in factor.Columns)
                    {
                        var by = variates.Next();
                        for (var k = 0; k < column.Length; k++)
                        {
                            off[factor.First + k] += by * column[k];
                        }
                    }
                }

                Solve(1);
                Solve(-1);
            }

            void Solve(double sign)
            {
                for (var k = 0; k < off.Length; k++)
                {
                    limits[k] = _gaps[k] + (sign * off[k]);
                }

                _seat.Solve(limits);
                air.Add(_seat.X[0]);
                if (slack is null)
                {
                    return;
                }

                double[] motion = [_seat.X[1], _seat.X[2], _seat.X[3]];
                for (var k = 0; k < off.Length; k++)
                {
                    var left = limits[k] + _motions.ChangeAt(k, motion) - _seat.X[0];
                    slack[k] = (slack[k].Sum + left, slack[k].Squares + (left * left));
                }
            }
        }
    }
}
