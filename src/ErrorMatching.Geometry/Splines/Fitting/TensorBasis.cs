namespace ErrorMatching.Geometry;

/// <summary>The nonzero products of basis functions at a pair of parameters, and their derivatives.</summary>
internal sealed class TensorBasis(KnotVector knotsU, KnotVector knotsV)
{
    private readonly double[] _u = new double[3 * (knotsU.Degree + 1)];
    private readonly double[] _v = new double[3 * (knotsV.Degree + 1)];
    private readonly double[] _product = new double[(knotsU.Degree + 1) * (knotsV.Degree + 1)];
    private int _firstU;
    private int _firstV;

    /// <summary>Moves to a pair of parameters.</summary>
    public void MoveTo(double u, double v, int order)
    {
        var (spanU, spanV) = (knotsU.SpanAt(u), knotsV.SpanAt(v));
        knotsU.Basis.WithDerivatives(spanU, u, order, _u);
        knotsV.Basis.WithDerivatives(spanV, v, order, _v);
        (_firstU, _firstV) = (spanU - knotsU.Degree, spanV - knotsV.Degree);
    }

    /// <summary>Indices of the poles with nonzero products, ascending.</summary>
    public int[] Poles()
    {
        var (rows, columns) = (knotsU.Degree + 1, knotsV.Degree + 1);
        var poles = new int[rows * columns];
        for (var i = 0; i < poles.Length; i++)
        {
            poles[i] = ((_firstU + (i / columns)) * knotsV.PoleCount) + _firstV + (i % columns);
        }

        return poles;
    }

    /// <summary>The products of derivatives of given orders; overwritten by the next call.</summary>
    public ReadOnlySpan<double> Of(int orderU, int orderV)
    {
        var (rows, columns) = (knotsU.Degree + 1, knotsV.Degree + 1);
        for (var i = 0; i < rows; i++)
        {
            for (var j = 0; j < columns; j++)
            {
                _product[(i * columns) + j] = _u[(orderU * rows) + i] * _v[(orderV * columns) + j];
            }
        }

        return _product;
    }
}
