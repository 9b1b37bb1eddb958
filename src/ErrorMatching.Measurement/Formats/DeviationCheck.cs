using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Checks the deviations of a feature table against actual - nominal. A gauge rounds the three numbers separately, so each may be
/// off by half of its last place. The number of places is determined from the whole column, because exports drop trailing zeros and a lone
/// "1" must not excuse a wrong sign.</summary>
internal sealed class DeviationCheck
{
    private readonly List<(DecimalNumber Nominal, DecimalNumber Actual, DecimalNumber Deviation, Cell Cell)> _rows = [];

    /// <summary>Adds a row.</summary>
    /// <exception cref="InputException">A cell is not a number.</exception>
    public void Add(Cell nominal, Cell actual, Cell deviation) =>
        _rows.Add((nominal.Number(), actual.Number(), deviation.Number(), deviation));

    /// <summary>Checks all rows.</summary>
    /// <exception cref="InputException">The first row whose deviation is not actual - nominal.</exception>
    public void Run()
    {
        if (_rows.Count == 0)
        {
            return;
        }

        var rounding = 0.5 * (
            _rows.Min(r => r.Nominal.LastPlace) + _rows.Min(r => r.Actual.LastPlace) + _rows.Min(r => r.Deviation.LastPlace));
        foreach (var (nominal, actual, deviation, cell) in _rows)
        {
            var expected = actual.Value - nominal.Value;
            var allowed = rounding + (1e-15 * (Math.Abs(actual.Value) + Math.Abs(nominal.Value)));
            if (Math.Abs(deviation.Value - expected) > allowed)
            {
                var isReversed = Math.Abs(deviation.Value + expected) <= allowed;
                throw cell.Fail(
                    MeasurementError.InconsistentDeviation,
                    string.Create(
                        CultureInfo.InvariantCulture, $"actual - nominal = {actual.Text} - {nominal.Text} = {Math.Round(expected, 12)}")
                    + (
                        isReversed
                            ? ": this file has nominal - actual, the opposite sign; correct its export"
                            : ": find out which of the three numbers is wrong"));
            }
        }
    }
}
