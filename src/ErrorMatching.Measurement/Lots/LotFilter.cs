using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>Follows the error of a process from piece to piece, over all histories that are still likely.</summary>
internal sealed class LotFilter
{
    // Standard deviations in uncertainties of a value, and how often each occurs. A step of a few uncertainties is believed at once; a
    // larger surprise is the piece's own until the next one confirms it, because a chip that is taken for the process costs a piece.
    private static readonly (LotEvent Happened, double Deviation, double Probability)[] _surprises =
    [
        (LotEvent.Step, 3.2, 0.015),
        (LotEvent.Step, 20, 0.0001),
        (LotEvent.Outlier, 11, 0.03),
        (LotEvent.Outlier, 60, 0.001),
    ];

    // After a change of the tool that somebody announced, a step is likely, and what looks like an outlier is one.
    private static readonly (LotEvent Happened, double Deviation, double Probability)[] _afterToolChange =
        [(LotEvent.Step, 3.2, 0.5), (LotEvent.Step, 20, 0.4)];

    // Histories that are followed, and how much less likely than the best one may be: e^-9 is a ten thousandth.
    private const int Most = 8;
    private const double Hopeless = 9;

    private readonly double _freedom;
    private readonly double _unit;
    private List<LotHistory> _histories;

    // The expected squares of the errors and drifts, mm^2.
    private double[] _squares;
    private double[] _driftSquares;

    /// <summary>Begins before the first piece.</summary>
    /// <param name="values">Number of values of a piece.</param>
    /// <param name="freedom">How many of them are independent.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of one measured point.</param>
    /// <param name="leastNoise">The part of it that stays in a value, squared.</param>
    public LotFilter(int values, double freedom, double uncertaintyMm, double leastNoise)
    {
        (_freedom, _unit) = (freedom, uncertaintyMm * uncertaintyMm);
        _histories = [LotHistory.Begin(LotModel.All(uncertaintyMm, leastNoise), values)];
        (Expected, _squares) = (new double[values], new double[values]);
        (Drift, _driftSquares) = (new double[values], new double[values]);
    }

    /// <summary>The expected errors of the next piece without corrections, mm.</summary>
    public double[] Expected { get; private set; }

    /// <summary>The expected change from piece to piece, mm.</summary>
    public double[] Drift { get; private set; }

    /// <summary>Standard deviation of a measured value about the error of the process, mm.</summary>
    public double NoiseMm { get; private set; }

    /// <summary>Variance of an expected error, mm^2.</summary>
    public double VarianceAt(int value) => Math.Max(0, _squares[value] - (Expected[value] * Expected[value]));

    /// <summary>Variance of an expected change, mm^2.</summary>
    public double DriftVarianceAt(int value) => Math.Max(0, _driftSquares[value] - (Drift[value] * Drift[value]));

    /// <summary>Takes the next piece.</summary>
    /// <param name="values">The errors that it would have without corrections, mm.</param>
    /// <param name="isAfterToolChange">True if the tool was changed before it.</param>
    public void Add(double[] values, bool isAfterToolChange = false)
    {
        var surprises = isAfterToolChange ? _afterToolChange : _surprises;
        LotSurprise ordinary = new(LotEvent.None, 0, 1 - surprises.Sum(s => s.Probability));
        LotSurprise[] possible = _histories[0].Events.Count == 0
            ? [ordinary with { Probability = 1 }]
            : [ordinary, .. surprises.Select(s => new LotSurprise(s.Happened, s.Deviation * s.Deviation * _unit, s.Probability))];
        var next = new List<(LotHistory Before, LotEvidence Evidence)>();
        foreach (var history in _histories)
        {
            var squares = history.SquaresOff(values);
            next.AddRange(possible.Select(s => (history, history.Explain(squares, _freedom, s))));
        }

        var best = next.Max(n => n.Evidence.LogWeight);
        _histories = [
            .. next.Where(n => n.Evidence.LogWeight > best - Hopeless)
                .OrderByDescending(n => n.Evidence.LogWeight)
                .Take(Most)
                .Select(n => n.Before.After(values, n.Evidence))];
        Conclude(values.Length);
    }

    /// <summary>Lets the process go on while pieces are cut that are not measured.</summary>
    /// <param name="pieces">Their number.</param>
    public void GoOn(int pieces)
    {
        for (var k = 0; k < pieces; k++)
        {
            _histories = [.. _histories.Select(h => h.OnePieceOn())];
        }

        Conclude(Expected.Length);
    }

    /// <summary>Probability that something happened at a piece, from 0.</summary>
    public double Probability(int piece, LotEvent happened) =>
        _histories.Zip(Weights(), (h, w) => h.Events[piece] == happened ? w : 0).Sum();

    private void Conclude(int values)
    {
        (Expected, _squares) = (new double[values], new double[values]);
        (Drift, _driftSquares) = (new double[values], new double[values]);
        var noise = 0.0;
        foreach (var (history, weight) in _histories.Zip(Weights()))
        {
            history.AddExpected(weight, Expected, _squares);
            history.AddDrift(weight, Drift, _driftSquares);
            noise += weight * history.Noise;
        }

        NoiseMm = Math.Sqrt(noise);
    }

    private double[] Weights()
    {
        var best = _histories.Max(h => h.LogWeight);
        double[] weights = [.. _histories.Select(h => Elementary.Exp(h.LogWeight - best))];
        var sum = weights.Sum();
        return [.. weights.Select(w => w / sum)];
    }
}
