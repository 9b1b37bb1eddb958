namespace ErrorMatching.Json;

/// <summary>A problem with the item it belongs to.</summary>
/// <param name="Item">The value that a rule refused.</param>
/// <param name="Problem">What is wrong.</param>
/// <param name="ByType">True if the rule wants another type of value: then it was not meant where there is an alternative.</param>
/// <param name="ByConst">True if a const refused it: then the alternative with that const was not meant.</param>
internal readonly record struct Finding(JsonItem Item, JsonProblem Problem, bool ByType = false, bool ByConst = false);
