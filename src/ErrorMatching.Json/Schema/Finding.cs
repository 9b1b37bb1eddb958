using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>A problem and the item that it refers to.</summary>
/// <param name="Item">The value that violates a rule.</param>
/// <param name="Problem">What is wrong.</param>
/// <param name="ByType">True if the rule requires another type. If there is an alternative, this one was not intended.</param>
/// <param name="ByConst">True if a const differs. The alternative with that const was not intended.</param>
internal readonly record struct Finding(JsonItem Item, Refusal Problem, bool ByType = false, bool ByConst = false);
