namespace ErrorMatching.Hmi;

/// <summary>A piece in a list.</summary>
/// <param name="Id">Number of its correction.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">The workpiece's name.</param>
/// <param name="Kind">Measured or predicted.</param>
/// <param name="Largest">The largest mating error with compensation.</param>
/// <param name="Severity">Alarm if a measured error is outside its limits, attention if a predicted one is.</param>
internal sealed record PieceRow(long Id, string Title, string Job, string Kind, string Largest, Severity Severity)
{
    public string AutomationId => "piece-" + Shown.Id(Id);
}
