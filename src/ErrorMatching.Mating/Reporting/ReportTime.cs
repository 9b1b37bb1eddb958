using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Measuring and calculating times.</summary>
/// <param name="MeasuringS">Measuring time by equation (7) of Wang 2021.</param>
/// <param name="CalculatingS">Measured time from reading the files to the written program; null if it was not timed.</param>
public readonly record struct ReportTime(double MeasuringS, double? CalculatingS)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Number("measuringS", MeasuringS);
        w.Number("calculatingS", CalculatingS);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportTime Read(ReportReader r) => new(r.Number("measuringS"), r.OptionalNumber("calculatingS"));
}
