namespace ErrorMatching.Hmi;

/// <summary>A correction found in the history.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Arrived">When its file arrived.</param>
/// <param name="Piece">Serial number, or the file's name.</param>
/// <param name="WorkOrder">The work order.</param>
/// <param name="Job">The job.</param>
/// <param name="State">Its state.</param>
/// <param name="Largest">Its largest displacement.</param>
internal sealed record HistoryRow(long Id, string Arrived, string Piece, string WorkOrder, string Job, string State, string Largest)
{
    public string Number => "#" + Shown.Id(Id);

    public string AutomationId => "found-" + Shown.Id(Id);
}
