using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A draft that can be gone back to.</summary>
/// <param name="Draft">The draft.</param>
/// <param name="Field">The field that was changed next; what is typed into one field is one step.</param>
internal sealed record EditStep(MatingDraft Draft, string Field);
