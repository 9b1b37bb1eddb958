namespace ErrorMatching.Mating;

/// <summary>The meaning of the coordinates in a gauge's file.</summary>
public enum ProbeReport
{
    /// <summary>Points where the stylus touched the piece.</summary>
    Contact,

    /// <summary>Centers of the stylus ball at the moment of touch.</summary>
    StylusCenter,
}
