namespace ErrorMatching.Mating;

/// <summary>The posterior covariance of deviations at several places of one field.</summary>
/// <remarks>Rasmussen and Williams (2006), equation 2.24: what was not known before, less what the key points explain.</remarks>
internal sealed class JointDeviation
{
    private readonly IReadOnlyList<DeviationPrior> _priors;
    private readonly IReadOnlyList<IReadOnlyList<RowTerm>> _places;
    private readonly double[][] _explained;

    /// <summary>Creates it.</summary>
    /// <param name="priors">The priors of the elements.</param>
    /// <param name="places">The places.</param>
    /// <param name="explained">For each place, its covariances with the key points, divided by the factor of theirs.</param>
    public JointDeviation(IReadOnlyList<DeviationPrior> priors, IReadOnlyList<IReadOnlyList<RowTerm>> places, double[][] explained) =>
        (_priors, _places, _explained) = (priors, places, explained);

    /// <summary>Number of places.</summary>
    public int Count => _places.Count;

    /// <summary>The covariance of two places, mm^2.</summary>
    public double Covariance(int place, int other)
    {
        var sum = DeviationField.Covariance(_priors, _places[place], _places[other]);
        var (a, b) = (_explained[place], _explained[other]);
        for (var i = 0; i < a.Length; i++)
        {
            sum -= a[i] * b[i];
        }

        return sum;
    }
}
