namespace ErrorMatching.Geometry;

/// <summary>A polynomial in powers of its variable, evaluated by Horner's rule. Immutable; equality compares the coefficients.</summary>
public sealed class Polynomial : IEquatable<Polynomial>
{
    private readonly double[] _coefficients;

    /// <summary>Creates a polynomial from ascending coefficients, constant first. Trailing zeros are dropped; none give zero.</summary>
    /// <param name="ascending">Coefficients of ascending powers, starting with the zeroth.</param>
    /// <exception cref="GeometryException">A coefficient is not finite (<see cref="GeometryError.NotFinite"/>).</exception>
    public Polynomial(params ReadOnlySpan<double> ascending)
    {
        for (var i = 0; i < ascending.Length; i++)
        {
            if (!double.IsFinite(ascending[i]))
            {
                throw new GeometryException(GeometryError.NotFinite, $"Coefficient {i} of a polynomial is not a finite number.");
            }
        }

        var count = ascending.Length;
        while (count > 1 && ascending[count - 1] == 0)
        {
            count--;
        }

        _coefficients = count == 0 ? [0] : ascending[..count].ToArray();
    }

    /// <summary>Coefficients in ascending powers: at least one, and the last is nonzero unless it is the only one.</summary>
    public IReadOnlyList<double> Coefficients => Array.AsReadOnly(_coefficients);

    /// <summary>The highest power, zero for a constant.</summary>
    public int Degree => _coefficients.Length - 1;

    /// <summary>The value at a place.</summary>
    public double Evaluate(double x)
    {
        var value = 0.0;
        for (var i = _coefficients.Length - 1; i >= 0; i--)
        {
            value = Math.FusedMultiplyAdd(value, x, _coefficients[i]);
        }

        return value;
    }

    /// <summary>The derivative; zero for a constant.</summary>
    public Polynomial Derivative()
    {
        var derived = new double[Degree];
        for (var i = 0; i < derived.Length; i++)
        {
            derived[i] = _coefficients[i + 1] * (i + 1);
        }

        return new(derived);
    }

    /// <inheritdoc/>
    public bool Equals(Polynomial? other) => other is not null && _coefficients.AsSpan().SequenceEqual(other._coefficients);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as Polynomial);

    /// <inheritdoc/>
    public override int GetHashCode()
    {
        var hash = default(HashCode);
        foreach (var coefficient in _coefficients)
        {
            hash.Add(coefficient);
        }

        return hash.ToHashCode();
    }
}
