using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A draft at one moment, to be checked and stored off the UI thread.</summary>
/// <param name="Job">The edited job.</param>
/// <param name="Draft">The draft.</param>
/// <param name="Base">The saved job that it was made from.</param>
/// <param name="BaseSha256">Hash of the saved job.</param>
/// <param name="By">Who edits.</param>
/// <param name="At">When.</param>
internal sealed record DraftSnapshot(
    CellJobSettings Job, MatingDraft Draft, MatingDraft Base, string BaseSha256, string By, DateTimeOffset At);
