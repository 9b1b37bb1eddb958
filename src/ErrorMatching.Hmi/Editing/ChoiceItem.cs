namespace ErrorMatching.Hmi;

/// <summary>An item of a choice.</summary>
/// <param name="Word">The job's word for it.</param>
/// <param name="Name">Its displayed name.</param>
internal sealed record ChoiceItem(string Word, string Name);
