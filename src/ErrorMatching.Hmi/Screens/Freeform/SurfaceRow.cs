namespace ErrorMatching.Hmi;

/// <summary>A measured surface in a list.</summary>
/// <param name="Id">Number of its correction.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">The workpiece's name.</param>
/// <param name="State">Its state.</param>
/// <param name="Profile">Its measured profile.</param>
/// <param name="Severity">Its severity.</param>
internal sealed record SurfaceRow(long Id, string Title, string Job, string State, string Profile, Severity Severity)
{
    public string AutomationId => "surface-" + Shown.Id(Id);
}
