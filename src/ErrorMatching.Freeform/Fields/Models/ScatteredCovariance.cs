namespace ErrorMatching.Freeform;

/// <summary>The covariance of scattered values: a full matrix.</summary>
internal sealed class ScatteredCovariance : Covariance
{
    private readonly FieldData _data;
    private readonly Kernel _kernel;
    private readonly BandedCholesky _factor;

    private ScatteredCovariance(FieldData data, Kernel kernel, BandedCholesky factor) => (_data, _kernel, _factor) = (data, kernel, factor);

    public override double LogDeterminant => _factor.LogDeterminant;

    public override double InverseTrace
    {
        get
        {
            var trace = 0.0;
            for (var k = 0; k < _data.Count; k++)
            {
                var unit = new double[_data.Count];
                unit[k] = 1;
                var forward = _factor.Forward(unit);
                trace += LeastSquares.Product(forward, forward);
            }

            return trace;
        }
    }

    public static ScatteredCovariance? Full(FieldData data, Kernel kernel)
    {
        var rows = new double[data.Count][];
        for (var i = 0; i < rows.Length; i++)
        {
            rows[i] = new double[i + 1];
            for (var j = 0; j < i; j++)
            {
                rows[i][j] = kernel.AlongU(data.U[i], data.U[j]) * kernel.AlongV(data.V[i], data.V[j]);
            }

            // Ten times the least noise of a grid, because factoring a full matrix loses more digits than two small decompositions.
            rows[i][i] = kernel.AtZero + Math.Max(kernel.Noise, 10 * Kernel.LeastNoise);
        }

        return BandedCholesky.Factor(rows, data.Count) is { } factor ? new(data, kernel, factor) : null;
    }

    public override int Leading => _data.Count;

    public override double[] Solve(double[] b) => _factor.Solve(b);

    public override double[] ToBasis(double[] b) => b;

    public override double[] SolveInBasis(double[] b) => _factor.Solve(b);

    public override double[] RowInBasis(double u, double v)
    {
        var row = new double[_data.Count];
        for (var k = 0; k < row.Length; k++)
        {
            row[k] = _kernel.AlongU(u, _data.U[k]) * _kernel.AlongV(v, _data.V[k]);
        }

        return row;
    }

    public override double Sum(double u, double v, double[] weights) => LeastSquares.Product(RowInBasis(u, v), weights);
}
