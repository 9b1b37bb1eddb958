namespace ErrorMatching.Freeform;

/// <summary>The systematic error of a surface along its normal, as a function of the surface's parameters, with its uncertainty.</summary>
public abstract class ErrorField
{
    /// <summary>The error at a place in millimeters, positive out of the material.</summary>
    /// <param name="u">First parameter of the nominal surface.</param>
    /// <param name="v">Second parameter of the nominal surface.</param>
    public abstract double At(double u, double v);

    /// <summary>Standard uncertainty of <see cref="At"/> in millimeters.</summary>
    /// <param name="u">First parameter of the nominal surface.</param>
    /// <param name="v">Second parameter of the nominal surface.</param>
    public abstract double StandardUncertaintyAt(double u, double v);
}
