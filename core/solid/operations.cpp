#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/solid/combine.h"
#include "core/surface/definition_text.h"

namespace solid {

std::span<const OperationRow> operationTable() {
    static constexpr OperationRow rows[] = {{"union", "Union", Operation::Union},
                                            {"difference", "Difference", Operation::Difference},
                                            {"intersection", "Intersection", Operation::Intersection}};
    return rows;
}

Operation operation(std::string_view id) {
    return base::rowOf(operationTable(), id, {"unknown operation \"%\"", "", "known are %"}, &OperationRow::id)
        .operation;
}

void requireSolid(const surface::Surface& model) {
    if (model.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(model.definition().manifold) + " bounds no solid", "",
                          "open the model as a surface");
    if (!model.tree().layout()->normals || !model.tree().layout()->oriented)
        throw base::Error("the points have no normals that tell inside from outside", "",
                          "give them some first, with \"normals\" and \"orient\"");
}

} // namespace solid
