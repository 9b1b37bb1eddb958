using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>One possible history of a lot: at which pieces the process moved, and which pieces were outliers. Holds a Kalman filter of the
/// error and its drift for each assumption, and how well each explains the pieces.</summary>
/// <remarks>The bank of filters is that of D. T. Magill, Optimal adaptive estimation of sampled stochastic processes, IEEE Transactions on
/// Automatic Control 10 (1965). All values of a piece share the variances of an assumption, so only the states differ between
/// them.</remarks>
internal sealed class LotHistory
{
    // An assumption that is less likely than the best by this much is dropped: e^-11 is a sixty thousandth.
    private const double Hopeless = 11;

    private readonly LotModel[] _models;
    private readonly double[] _logs;
    private readonly (double Error, double Both, double Drift)[] _variances;

    // The states of one assumption after the other, each with all values.
    private readonly double[] _errors;
    private readonly double[] _drifts;

    private LotHistory(
        LotModel[] models, double[] logs, (double Error, double Both, double Drift)[] variances, double[] errors, double[] drifts) =>
        (_models, _logs, _variances, _errors, _drifts) = (models, logs, variances, errors, drifts);

    /// <summary>Logarithm of its probability, apart from a constant that all histories share.</summary>
    public double LogWeight { get; private init; }

    /// <summary>What happened at each piece.</summary>
    public IReadOnlyList<LotEvent> Events { get; private init; } = [];

    /// <summary>The history before the first piece.</summary>
    public static LotHistory Begin(LotModel[] models, int values) => new(
        models,
        [.. models.Select(m => m.LogPrior)],
        [.. models.Select(m => (m.Start, 0.0, m.Drift))],
        new double[models.Length * values],
        new double[models.Length * values]);

    /// <summary>The mean squares by which a piece is off the expectation of each assumption.</summary>
    /// <param name="values">The errors that the piece would have without corrections.</param>
    public double[] SquaresOff(double[] values)
    {
        var squares = new double[_models.Length];
        for (var m = 0; m < squares.Length; m++)
        {
            for (var i = 0; i < values.Length; i++)
            {
                var off = values[i] - _errors[(m * values.Length) + i];
                squares[m] += off * off / values.Length;
            }
        }

        return squares;
    }

    /// <summary>How likely each assumption is after a piece, and all of them together.</summary>
    /// <param name="squares">The squares of the piece.</param>
    /// <param name="freedom">How many of its values are independent.</param>
    /// <param name="surprise">What happened at the piece.</param>
    public LotEvidence Explain(double[] squares, double freedom, LotSurprise surprise)
    {
        var logs = new double[squares.Length];
        for (var m = 0; m < logs.Length; m++)
        {
            var innovation = _variances[m].Error + _models[m].Noise + surprise.Variance;
            logs[m] = _logs[m] - (freedom * (Elementary.Log(innovation) + (squares[m] / innovation)) / 2);
        }

        var best = logs.Max();
        var evidence = best + Elementary.Log(logs.Sum(l => Elementary.Exp(l - best)));
        return new(surprise, logs, evidence, LogWeight + evidence + Elementary.Log(surprise.Probability));
    }

    /// <summary>The history one piece later.</summary>
    /// <param name="values">The errors that the piece would have without corrections.</param>
    /// <param name="evidence">What explains it.</param>
    public LotHistory After(double[] values, LotEvidence evidence)
    {
        var best = evidence.Logs.Max();
        int[] kept = [.. Enumerable.Range(0, evidence.Logs.Length).Where(m => evidence.Logs[m] > best - Hopeless)];
        var variances = new (double Error, double Both, double Drift)[kept.Length];
        var (errors, drifts) = (new double[kept.Length * values.Length], new double[kept.Length * values.Length]);
        var (step, outlier) = evidence.Surprise.Happened == LotEvent.Step
            ? (evidence.Surprise.Variance, 0.0)
            : (0.0, evidence.Surprise.Variance);
        for (var k = 0; k < kept.Length; k++)
        {
            var m = kept[k];
            var (error, both, drift) = (_variances[m].Error + step, _variances[m].Both, _variances[m].Drift);
            var innovation = error + _models[m].Noise + outlier;
            var (ofError, ofDrift) = (error / innovation, both / innovation);
            for (var i = 0; i < values.Length; i++)
            {
                var (from, to) = ((m * values.Length) + i, (k * values.Length) + i);
                var off = values[i] - _errors[from];
                drifts[to] = _drifts[from] + (ofDrift * off);
                errors[to] = _errors[from] + (ofError * off) + drifts[to];
            }

            // Corrected by the piece, then one piece ahead.
            variances[k] = OnePieceOn(
                (error - (ofError * error), both - (ofError * both), drift - (ofDrift * both)), _models[m].Walk);
        }

        return new([.. kept.Select(m => _models[m])], [.. kept.Select(m => evidence.Logs[m] - evidence.Log)], variances, errors, drifts)
        {
            LogWeight = evidence.LogWeight,
            Events = [.. Events, evidence.Surprise.Happened],
        };
    }

    /// <summary>The history one piece later that is not measured.</summary>
    public LotHistory OnePieceOn() => new(
        _models,
        _logs,
        [.. _variances.Select((v, m) => OnePieceOn(v, _models[m].Walk))],
        [.. _errors.Zip(_drifts, (error, drift) => error + drift)],
        _drifts)
    {
        LogWeight = LogWeight,
        Events = Events,
    };

    private static (double Error, double Both, double Drift) OnePieceOn((double Error, double Both, double Drift) v, double walk) =>
        (v.Error + (2 * v.Both) + v.Drift + walk, v.Both + v.Drift, v.Drift);

    /// <summary>Adds the expected errors of the next piece, and their squares with their variance.</summary>
    /// <param name="weight">The probability of this history.</param>
    /// <param name="means">Sum of the errors, for each value.</param>
    /// <param name="squares">Sum of their squares.</param>
    public void AddExpected(double weight, double[] means, double[] squares) =>
        Add(weight, _errors, m => _variances[m].Error, means, squares);

    /// <summary>Adds the drift per piece in the same way.</summary>
    public void AddDrift(double weight, double[] means, double[] squares) =>
        Add(weight, _drifts, m => _variances[m].Drift, means, squares);

    /// <summary>The expected variance of a measured value about the error of the process.</summary>
    public double Noise => _models.Zip(_logs, (model, log) => Elementary.Exp(log) * model.Noise).Sum();

    private void Add(double weight, double[] states, Func<int, double> variance, double[] means, double[] squares)
    {
        for (var m = 0; m < _models.Length; m++)
        {
            var part = weight * Elementary.Exp(_logs[m]);
            for (var i = 0; i < means.Length; i++)
            {
                var state = states[(m * means.Length) + i];
                means[i] += part * state;
                squares[i] += part * ((state * state) + variance(m));
            }
        }
    }
}

/// <summary>Something that may happen at any piece.</summary>
/// <param name="Happened">What.</param>
/// <param name="Variance">The variance that it adds: to the error of the process by a step, to the noise by an outlier; mm^2.</param>
/// <param name="Probability">How often it happens.</param>
internal readonly record struct LotSurprise(LotEvent Happened, double Variance, double Probability);

/// <summary>How well a history explains a piece if something happened there.</summary>
/// <param name="Surprise">What happened.</param>
/// <param name="Logs">Logarithm of the probability of each assumption, apart from a constant.</param>
/// <param name="Log">That of all of them together.</param>
/// <param name="LogWeight">Logarithm of the probability of the history that results, apart from the constant that all histories
/// share.</param>
internal sealed record LotEvidence(LotSurprise Surprise, double[] Logs, double Log, double LogWeight);
