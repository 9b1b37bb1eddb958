using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A draft in the undo history.</summary>
/// <param name="Draft">The draft.</param>
/// <param name="Field">The field that was changed next; successive input in one field is one step.</param>
internal sealed record EditStep(MatingDraft Draft, string Field);
